/** What the simulation needs of a browser. */

/** A module with two SIMD instructions (i8x16.splat, i8x16.popcnt). */
const withSimd = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11);

/** Why this browser cannot simulate, in words; null if it can. */
export function unable(): string | null {
  const lacks = typeof WebAssembly === "undefined" ? "WebAssembly" : WebAssembly.validate(withSimd) ? "" : "WebAssembly SIMD";
  if (!lacks) return null;
  return (
    `This browser, on this processor, has no ${lacks}, which the simulation needs. Chrome and Edge 91, Firefox 89 and Safari 16.4 (iOS 16.4) have it, and later ones. ` +
    "Some browsers switch WebAssembly off in their strictest setting, such as the lockdown mode of iOS. Another browser or device opens the same file; the program needs no browser."
  );
}
