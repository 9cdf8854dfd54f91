/** The little of plotly that the pages use. */
declare module "plotly.js-cartesian-dist-min" {
  type Json = Record<string, unknown>;
  const Plotly: {
    react(element: HTMLElement, data: Json[], layout: Json, config: Json): Promise<unknown>;
    Plots: { resize(element: HTMLElement): void };
  };
  export default Plotly;
}
