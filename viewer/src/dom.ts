/** Elements in one call, and the parts that the pages have. */
import type { Fact } from "./contract";

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

// Printing: what waits to be seen is drawn before, for the width of the paper and in the colours of a light page.

let printing = false;
let listening = false;
let drawn: { element: Element; draw: () => void }[] = [];

/** True while the page is being printed. */
export const onPaper = (): boolean => printing;

function set(now: boolean): void {
  printing = now;
  document.documentElement.classList.toggle("on-paper", now);
  drawn = drawn.filter((one) => one.element.isConnected);
  // Drawing may append new elements to the list; the loop draws these too.
  for (let i = 0; i < drawn.length; ++i) drawn[i].draw();
}

/**
 * @param draw  at once, for the width that `element` has then; called before printing and again after it
 * @param gone  when it no longer is
 */
export function onPrint(element: Element, draw: () => void, gone?: AbortSignal): void {
  const one = { element, draw };
  drawn.push(one);
  gone?.addEventListener("abort", () => {
    drawn = drawn.filter((other) => other !== one);
  });
  if (listening) return;
  listening = true;
  addEventListener("beforeprint", () => set(true));
  addEventListener("afterprint", () => set(false));
}
