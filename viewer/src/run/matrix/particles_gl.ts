/**
 * The matrix on the graphics card. All frames are uploaded once, as they were stored; a picture then costs a few offsets
 * into them and one call, and the card does the interpolation.
 */
import { gelOnDark, gelOnLight, lookUp } from "../../colour";
import type { Field } from "../../unpack";
import { solidFrom, type Film } from "../frames";
import { isSoftware, program, texture } from "./gl";
import { fluidSize, intactSize, type ParticlePainter, type ParticleScene } from "./particle_scene";
import { smoothOnCard } from "./smooth_gl";

const vertexSource = `#version 300 es
layout(location = 0) in vec2 corner;
layout(location = 1) in vec2 x0;
layout(location = 2) in vec2 x1;
layout(location = 3) in vec2 X;
layout(location = 4) in float f0;
layout(location = 5) in float f1;
layout(location = 6) in float v0;
layout(location = 7) in float v1;
uniform vec2 xMap, XMap, fMap, vMap;   // value = y + x * q
uniform float fraction, spacing, intact, fluid;
uniform vec2 centre, toClip, limits;
uniform bool displacement;
out float place;
out float solid;
void main() {
  vec2 x = xMap.y + xMap.x * mix(x0, x1, fraction);
  float f = fMap.y + fMap.x * mix(f0, f1, fraction);
  float v = displacement ? distance(x, XMap.y + XMap.x * X) : vMap.y + vMap.x * mix(v0, v1, fraction);
  place = (v - limits.x) / (limits.y - limits.x);
  solid = f;
  gl_Position = vec4((x - centre + corner * spacing * mix(fluid, intact, f)) * toClip, 0.0, 1.0);
}`;

const fragmentSource = `#version 300 es
precision highp float;
in float place;
in float solid;
uniform sampler2D colours;
uniform vec3 ground;
uniform float solidFrom;
out vec4 colour;
void main() {
  colour = solid < solidFrom ? vec4(ground, 1.0) : vec4(texture(colours, vec2(clamp(place, 0.002, 0.998), 0.5)).rgb, 1.0);
}`;

function upload(gl: WebGL2RenderingContext, data: ArrayBufferView): WebGLBuffer | null {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  return buffer;
}

/** null where there is no WebGL2, or only one computed by the processor (unless that is asked for): a plain canvas is faster. */
export function cardPainter(
  canvas: HTMLCanvasElement,
  film: Film,
  spacing: number,
  lost: () => void,
  anyhow: boolean,
): ParticlePainter | null {
  const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, failIfMajorPerformanceCaveat: !anyhow });
  if (!gl || (!anyhow && isSoftware(gl))) return null;
  const squares = program(gl, vertexSource, fragmentSource);
  const smooth = smoothOnCard(gl, 0, 1);
  if (!squares || !smooth) return null;
  const { used, uniforms } = squares;
  const closed = new AbortController();
  canvas.addEventListener("webglcontextlost", lost, { once: true, signal: closed.signal });
  const attributes = gl.createVertexArray();
  gl.bindVertexArray(attributes);

  const buffers = new Map<Field, WebGLBuffer | null>();
  const attribute = (location: number, field: Field, frame: number): void => {
    const uploaded = buffers.has(field);
    if (!uploaded) buffers.set(field, upload(gl, field.q));
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers.get(field) ?? null);
    if (uploaded && film.growing)
      gl.bufferSubData(
        gl.ARRAY_BUFFER,
        frame * field.step * field.q.BYTES_PER_ELEMENT,
        field.q,
        frame * field.step,
        field.stride,
      );
    const type = field.q instanceof Int16Array ? gl.SHORT : gl.UNSIGNED_BYTE;
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(
      location,
      field.components,
      type,
      false,
      0,
      frame * field.step * field.q.BYTES_PER_ELEMENT,
    );
    gl.vertexAttribDivisor(location, 1);
  };

  upload(gl, new Float32Array([-0.5, -0.5, 0.5, -0.5, -0.5, 0.5, 0.5, 0.5]));
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  texture(gl, 1, gl.NEAREST);
  texture(gl, 0, gl.LINEAR);

  const paint = (scene: ParticleScene): void => {
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.activeTexture(gl.TEXTURE0);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, lookUp(scene.scale.map));
    if (scene.patch) smooth(scene, scene.patch);
    else paintSquares(scene);
  };

  const paintSquares = ({ place, layer, scale, camera, dark }: ParticleScene): void => {
    gl.useProgram(used);
    gl.bindVertexArray(attributes);
    const value = layer.field ?? film.f;
    for (const [location, field, frame] of [
      [1, film.x, place.frame],
      [2, film.x, place.next],
      [3, film.reference, 0],
      [4, film.f, place.frame],
      [5, film.f, place.next],
      [6, value, place.frame],
      [7, value, place.next],
    ] as const)
      attribute(location, field, frame);
    for (const [name, field] of [
      ["xMap", film.x],
      ["XMap", film.reference],
      ["fMap", film.f],
      ["vMap", value],
    ] as const)
      gl.uniform2f(uniforms[name], field.scale, field.offset);
    const ground = (dark ? gelOnDark : gelOnLight)[0];
    gl.uniform3f(uniforms["ground"], ground[0] / 255, ground[1] / 255, ground[2] / 255);
    gl.uniform1f(uniforms["solidFrom"], layer.solidOnly ? solidFrom : -1);
    gl.uniform1f(uniforms["fraction"], place.fraction);
    gl.uniform1f(uniforms["spacing"], spacing);
    gl.uniform1f(uniforms["intact"], intactSize(spacing * camera.scale));
    gl.uniform1f(uniforms["fluid"], fluidSize);
    gl.uniform2f(uniforms["centre"], camera.x, camera.y);
    gl.uniform2f(uniforms["toClip"], (2 * camera.scale) / camera.width, (2 * camera.scale) / camera.height);
    gl.uniform2f(uniforms["limits"], scale.low, scale.high);
    gl.uniform1i(uniforms["displacement"], layer.field ? 0 : 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, film.particles);
  };
  const close = (): void => {
    closed.abort();
    // A browser has few contexts to give; one that is no longer seen must not wait for the garbage collector.
    gl.getExtension("WEBGL_lose_context")?.loseContext();
  };
  return { canvas, kind: "webgl2", paint, close };
}
