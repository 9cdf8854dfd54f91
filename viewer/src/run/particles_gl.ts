/**
 * The matrix on the graphics card. All frames are uploaded once, as they were stored; a picture then costs a few offsets
 * into them and one call, and the card does the interpolation.
 */
import { gelOnDark, gelOnLight, lookUp } from "../colour";
import type { Field } from "../unpack";
import type { Film } from "./frames";
import { fluidSize, intactSize, solidFrom, type ParticlePainter, type ParticleScene } from "./particle_scene";

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

/** Whether the processor plays the card. Some browsers do not count that as the caveat they are asked about. */
function isSoftware(gl: WebGL2RenderingContext): boolean {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return info !== null && /swiftshader|llvmpipe|software/i.test(String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)));
}

function program(gl: WebGL2RenderingContext): WebGLProgram | null {
  const made = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertexSource],
    [gl.FRAGMENT_SHADER, fragmentSource],
  ] as const) {
    const shader = gl.createShader(type);
    if (!made || !shader) return null;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  if (!made) return null;
  gl.linkProgram(made);
  return gl.getProgramParameter(made, gl.LINK_STATUS) ? made : null;
}

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
  const used = program(gl);
  if (!used) return null;
  const closed = new AbortController();
  canvas.addEventListener("webglcontextlost", lost, { once: true, signal: closed.signal });
  gl.useProgram(used);
  const at = (name: string) => gl.getUniformLocation(used, name);
  const uniforms = Object.fromEntries(
    [
      "xMap",
      "XMap",
      "fMap",
      "vMap",
      "fraction",
      "spacing",
      "intact",
      "fluid",
      "centre",
      "toClip",
      "limits",
      "displacement",
      "ground",
      "solidFrom",
    ].map((name) => [name, at(name)]),
  );

  const buffers = new Map<Field, WebGLBuffer | null>();
  const attribute = (location: number, field: Field, frame: number): void => {
    if (!buffers.has(field)) buffers.set(field, upload(gl, field.q));
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers.get(field) ?? null);
    const type = field.q instanceof Int16Array ? gl.SHORT : gl.UNSIGNED_BYTE;
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(
      location,
      field.components,
      type,
      false,
      0,
      frame * field.stride * field.q.BYTES_PER_ELEMENT,
    );
    gl.vertexAttribDivisor(location, 1);
  };

  upload(gl, new Float32Array([-0.5, -0.5, 0.5, -0.5, -0.5, 0.5, 0.5, 0.5]));
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);

  const paint = ({ place, layer, camera, dark }: ParticleScene): void => {
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
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
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, lookUp(layer.map(dark)));
    const ground = (dark ? gelOnDark : gelOnLight)[0];
    gl.uniform3f(uniforms["ground"], ground[0] / 255, ground[1] / 255, ground[2] / 255);
    gl.uniform1f(uniforms["solidFrom"], layer.solidOnly ? solidFrom : -1);
    gl.uniform1f(uniforms["fraction"], place.fraction);
    gl.uniform1f(uniforms["spacing"], spacing);
    gl.uniform1f(uniforms["intact"], intactSize(spacing * camera.scale));
    gl.uniform1f(uniforms["fluid"], fluidSize);
    gl.uniform2f(uniforms["centre"], camera.x, camera.y);
    gl.uniform2f(uniforms["toClip"], (2 * camera.scale) / camera.width, (2 * camera.scale) / camera.height);
    gl.uniform2f(uniforms["limits"], layer.low, layer.high);
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
