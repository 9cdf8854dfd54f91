/** Elements in one call, and the parts that the pages have. */
import type { Fact } from "./contract";
import { onPaper } from "./paper";

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | undefined>;

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes))
    if (value !== undefined && value !== false) element.setAttribute(name, value === true ? "" : String(value));
  for (const child of children) if (child) element.append(child);
}

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

export function s<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  fill(element, attributes, children);
  return element;
}

/** Text of an element, left alone where it is the same: a page that plays says much thirty times a second. */
export function setText(element: Element, text: string): void {
  const only = element.childNodes.length === 1 ? element.firstChild : null;
  if (only instanceof Text) {
    if (only.data !== text) only.data = text;
  } else element.textContent = text;
}

export function section(id: string, title: string, ...children: Child[]): HTMLElement {
  return h("section", { id, "aria-labelledby": `${id}-title` }, h("h2", { id: `${id}-title` }, title), ...children);
}

/** A table that scrolls sideways where it does not fit. Columns of numbers are set to the right. */
export function table(
  heads: string[],
  rows: Child[][],
  options: { numeric?: number[]; caption?: string } = {},
): HTMLElement {
  const kind = (column: number) => (options.numeric?.includes(column) ? "number" : undefined);
  const head = h("tr", {}, ...heads.map((text, i) => h("th", { scope: "col", class: kind(i) }, text)));
  const body = rows.map((row) =>
    h("tr", {}, ...row.map((cell, i) => h("td", { class: kind(i), "data-label": heads[i] }, cell))),
  );
  return h(
    "div",
    { class: "table", tabindex: 0, role: "group", "aria-label": options.caption ?? heads.join(", ") },
    h(
      "table",
      {},
      options.caption ? h("caption", { class: "unseen" }, options.caption) : null,
      h("thead", {}, head),
      h("tbody", {}, ...body),
    ),
  );
}

/** What was computed, when and how. */
export const factList = (facts: Fact[]): HTMLElement =>
  h("dl", { class: "facts" }, ...facts.map((f) => h("div", {}, h("dt", {}, f.name), h("dd", {}, f.value))));

/** Shown instead of a page that cannot be made. */
export function fault(message: string): HTMLElement {
  return h("div", { class: "fault", role: "alert" }, h("h1", {}, "This page cannot be shown"), h("p", {}, message));
}

/** @param gone  when the listener is no longer wanted */
export function onDarkMode(listener: () => void, gone: AbortSignal): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", listener, { signal: gone });
}

/** Calls once it has a size, and whenever that changes. */
export function onResize(element: Element, listener: () => void, gone: AbortSignal): void {
  const observer = new ResizeObserver(listener);
  observer.observe(element);
  gone.addEventListener("abort", () => observer.disconnect());
}

export const isDark = (): boolean => !onPaper() && matchMedia("(prefers-color-scheme: dark)").matches;
export const wantsStillness = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;
