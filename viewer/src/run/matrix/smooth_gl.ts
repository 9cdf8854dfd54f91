/** The interpolated matrix on the graphics card: the sums go up as a texture, and each pixel divides them. */
import { gelOnDark, gelOnLight } from "../../colour";
import { program } from "./gl";
import type { ParticleScene } from "./particle_scene";
import { contourEnds, coverage, leastShare, solidShare, type Patch } from "./resample";
import { hatchPeriod, hatchStrength, hatchWidth } from "./scale";

const vertexSource = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;

const fragmentSource = `#version 300 es
precision highp float;
uniform highp sampler2D sums;
uniform sampler2D colours;
uniform vec3 ground;
uniform vec2 limits, covered, solidShare, corner;   // corner: of the picture below left, in nodes
uniform vec2 contour;                               // values between which sides change; both 0 without a contour
uniform float leastShare;
uniform float nodesPerPixel, pixels, height;
uniform vec3 hatch;                                 // period, width, strength; 0 for none
out vec4 colour;
float ramp(vec2 ends, float v) { return clamp((v - ends.x) / (ends.y - ends.x), 0.0, 1.0); }
vec3 painted(float value, vec2 seen) {
  float place = (value - limits.x) / (limits.y - limits.x);
  vec3 c = texelFetch(colours, ivec2(int(round(255.0 * clamp(place, 0.0, 1.0))), 0), 0).rgb;
  if (hatch.z > 0.0 && (place > 1.00004 || place < -0.00004) && mod(seen.x + height - seen.y, hatch.x) < hatch.y)
    c = mix(c, vec3(dot(c, vec3(0.3, 0.59, 0.11)) > 0.502 ? 0.0 : 1.0), hatch.z);
  return c;
}
void main() {
  vec2 seen = gl_FragCoord.xy / pixels;
  vec2 at = corner + nodesPerPixel * seen;
  ivec2 node = ivec2(floor(at));
  vec2 f = at - vec2(node);
  vec4 sum = mix(mix(texelFetch(sums, node, 0), texelFetch(sums, node + ivec2(1, 0), 0), f.x),
                 mix(texelFetch(sums, node + ivec2(0, 1), 0), texelFetch(sums, node + ivec2(1, 1), 0), f.x), f.y);
  float alpha = ramp(covered, sum.z);
  float mean = sum.z > 0.0 ? sum.w / sum.z : 0.0;
  float least = leastShare * sum.z;
  float above = sum.y > least ? sum.x / sum.y : mean;
  vec3 c;
  if (contour.y > contour.x) {
    float below = sum.z - sum.y > least ? (sum.w - sum.x) / (sum.z - sum.y) : mean;
    c = mix(painted(below, seen), painted(above, seen), ramp(contour, mean));
  } else
    c = mix(ground, painted(above, seen), sum.z > 0.0 ? ramp(solidShare, sum.y / sum.z) : 0.0);
  colour = vec4(c * alpha, alpha);
}`;

/**
 * @param colourUnit  texture unit with the colour map   @param sumsUnit  texture unit that is free for the sums
 */
export function smoothOnCard(
  gl: WebGL2RenderingContext,
  colourUnit: number,
  sumsUnit: number,
): ((scene: ParticleScene, patch: Patch) => void) | null {
  const made = program(gl, vertexSource, fragmentSource);
  if (!made) return null;
  const { used, uniforms: at } = made;
  const corners = gl.createVertexArray();
  return ({ camera, scale, dark, pixels }, patch) => {
    gl.useProgram(used);
    gl.bindVertexArray(corners);
    gl.activeTexture(gl.TEXTURE0 + sumsUnit);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, patch.columns, patch.rows, 0, gl.RGBA, gl.FLOAT, patch.sums);
    gl.uniform1i(at["sums"], sumsUnit);
    gl.uniform1i(at["colours"], colourUnit);
    const ground = (dark ? gelOnDark : gelOnLight)[0];
    gl.uniform3f(at["ground"], ground[0] / 255, ground[1] / 255, ground[2] / 255);
    gl.uniform2f(at["limits"], scale.low, scale.high);
    gl.uniform2f(at["covered"], ...coverage);
    gl.uniform2f(at["solidShare"], ...solidShare);
    const [from, to] = patch.contour === undefined ? [0, 0] : contourEnds(patch.contour);
    gl.uniform2f(at["contour"], from, to);
    gl.uniform1f(at["leastShare"], leastShare);
    gl.uniform2f(
      at["corner"],
      (camera.x - (0.5 * camera.width) / camera.scale - patch.left) / patch.step,
      (camera.y - (0.5 * camera.height) / camera.scale - patch.bottom) / patch.step,
    );
    gl.uniform1f(at["nodesPerPixel"], 1 / (camera.scale * patch.step));
    gl.uniform1f(at["pixels"], pixels);
    gl.uniform1f(at["height"], camera.height);
    gl.uniform3f(at["hatch"], hatchPeriod, hatchWidth, scale.hatched ? hatchStrength : 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };
}
