/** Which version the page is of, and the licences of what it contains. */
import { h } from "../dom";
import { fromBase64, inflate } from "../unpack";

const unpacked = async (text: string): Promise<string> => new TextDecoder().decode(await inflate(fromBase64(text.trim())));

export function about(): HTMLElement {
  const text = document.getElementById("matrigrate-notices")?.textContent?.trim() ?? "";
  const end = text.indexOf("\n");
  const version = end < 0 ? "Matrigrate" : text.slice(0, end).replace(/(?<=commit [0-9a-f]{10})[0-9a-f]+/, "");
  const pre = h("pre", {});
  const licences = h("details", { class: "licences" }, h("summary", {}, "Licences of what this page contains"), pre);
  // The text is long: it is compressed, and laid out only where it is read.
  licences.addEventListener("toggle", () => {
    pre.textContent = "";
    if (licences.open)
      unpacked(text.slice(end + 1)).then(
        (terms) => (pre.textContent = terms.trim()),
        (reason: unknown) => (pre.textContent = String(reason)),
      );
  });
  return h("footer", {}, h("p", {}, `${version}. This page is one file: it asks no network, and may be copied and given away.`), licences);
}
