/** Puts data into a template, as the program does. */
import { readFileSync } from "node:fs";

const placeholder = '<script type="application/json" id="matrigrate-data">null</script>';

export function embed(template: string, json: string): string {
  const html = readFileSync(template, "utf8");
  if (html.split(placeholder).length !== 2) throw new Error(`${template}: the placeholder is not there once`);
  return html.replace(placeholder, () => placeholder.replace("null", () => json.replace(/</g, "\\u003c")));
}
