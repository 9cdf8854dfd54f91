/** Elements in one call, and the parts that the pages have. */
import type { Fact } from "./contract";

type Child = Node | string | null | undefined | false;
type Html = HTMLElementTagNameMap;
type Svg = SVGElementTagNameMap;
/** A function is called with the element at each of its events: "onclick". */
type Attributes<E = Element> = Record<string, string | number | boolean | undefined | ((element: E) => unknown)>;

function filled<E extends Element>(element: E, attributes: Attributes<E>, children: Child[]): E {
  for (const [name, value] of Object.entries(attributes))
    if (typeof value === "function") element.addEventListener(name.slice(2), () => value(element));
    else if (value !== undefined && value !== false) element.setAttribute(name, value === true ? "" : String(value));
  for (const child of children) if (child) element.append(child);
  return element;
}

export const h = <K extends keyof Html>(tag: K, attributes: Attributes<Html[K]> = {}, ...children: Child[]): Html[K] =>
  filled(document.createElement(tag), attributes, children);

export const s = <K extends keyof Svg>(tag: K, attributes: Attributes<Svg[K]> = {}, ...children: Child[]): Svg[K] =>
  filled(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);

export const button = (text: string, attributes: Attributes<HTMLButtonElement>): HTMLButtonElement =>
  h("button", { type: "button", ...attributes }, text);

type Options = [value: string | number, words: string][];
/** @param chosen  value that is chosen at first   @param act  called with each that is chosen later */
export const select = (attributes: Attributes<HTMLSelectElement>, options: Options, act: (value: string) => unknown, chosen?: string | number) =>
  h(
    "select",
    { ...attributes, onchange: ({ value }) => act(value) },
    ...options.map(([value, words]) => h("option", { value, selected: value === chosen }, words)),
  );

/** A box or, of type "radio", a button with its words. */
export const choice = (attributes: Attributes<HTMLInputElement>, words: string, act: (checked: boolean) => unknown) => {
  const input = h("input", { type: "checkbox", ...attributes, onchange: ({ checked }) => act(checked) });
  return { input, label: h("label", {}, input, words) };
};

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

/** What a phase of a protrusion is drawn in. */
export const phaseFill = (phase: number): string => `var(--phase${phase})`;
export const phaseDot = (phase: number): HTMLElement => h("span", { class: "dot", style: `background:${phaseFill(phase)}` });

/** A table that scrolls sideways where it does not fit. Columns of numbers are set to the right. */
export function table(caption: string, heads: string[], rows: Child[][], numeric: number[] = []): HTMLElement {
  const kind = (column: number) => (numeric.includes(column) ? "number" : undefined);
  const head = h("tr", {}, ...heads.map((text, i) => h("th", { scope: "col", class: kind(i) }, text)));
  const cell = (content: Child, i: number) => h("td", { class: kind(i), "data-label": heads[i] }, content);
  const body = rows.map((row) => h("tr", {}, ...row.map(cell)));
  const inside = [h("caption", { class: "unseen" }, caption), h("thead", {}, head), h("tbody", {}, ...body)];
  return h("div", { class: "table", tabindex: 0, role: "group", "aria-label": caption }, h("table", {}, ...inside));
}

/** How the page came about, and how to cite it. */
export const sources = ({ provenance, citation }: { provenance: string; citation: string }): HTMLElement[] => [
  ...(provenance ? [section("provenance", "Provenance", h("pre", {}, provenance))] : []),
  section("citation", "To cite", h("p", { class: "citation" }, citation)),
];

/** The head and the title of a page: what it is of, how far it came and what came out, and what was computed, when and how. */
export function header(title: string, status: string, summary: Child[], facts: Fact[]): HTMLElement {
  document.title = title;
  return h(
    "header",
    {},
    h("h1", {}, title),
    h("p", { class: "status" }, status, ...(summary.length > 0 ? [" ", h("strong", {}, ...summary)] : [])),
    h("dl", { class: "facts" }, ...facts.map((f) => h("div", {}, h("dt", {}, f.name), h("dd", {}, f.value)))),
  );
}

export const messageOf = (reason: unknown): string => (reason instanceof Error ? reason.message : String(reason));

/** Fills the page, or says on it why it cannot be shown; then tells programs that it is ready. */
export async function fillPage(show: (page: HTMLElement) => unknown): Promise<void> {
  const page = document.getElementById("page")!;
  try {
    await show(page);
  } catch (reason) {
    const words = [h("h1", {}, "This page cannot be shown"), h("p", {}, messageOf(reason))];
    page.replaceChildren(h("div", { class: "fault", role: "alert" }, ...words));
  }
  document.documentElement.dataset["ready"] = "true";
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

/** Calls when it comes into the window, or as near to it as `margin` says. */
export function onceNear(element: Element, margin: string, act: () => void): void {
  const observer = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      act();
    },
    { rootMargin: margin },
  );
  observer.observe(element);
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
