/** What the painters on the graphics card share: programs and their uniforms. */

export interface Program {
  /** Compiled and linked. */
  used: WebGLProgram;
  uniforms: Record<string, WebGLUniformLocation | null>;
}

export function program(gl: WebGL2RenderingContext, vertex: string, fragment: string): Program | null {
  const made = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type);
    if (!made || !shader) return null;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  if (!made) return null;
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) return null;
  const names = Array.from(
    { length: gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) as number },
    (_, i) => gl.getActiveUniform(made, i)?.name ?? "",
  );
  return { used: made, uniforms: Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(made, name)])) };
}

/** Whether WebGL runs in software. `failIfMajorPerformanceCaveat` does not detect that in every browser. */
export function isSoftware(gl: WebGL2RenderingContext): boolean {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return info !== null && /swiftshader|llvmpipe|software/i.test(String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)));
}

/** A texture on its unit, without wrapping; `filter` between its texels. */
export function texture(gl: WebGL2RenderingContext, unit: number, filter: number): void {
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, filter);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
}
