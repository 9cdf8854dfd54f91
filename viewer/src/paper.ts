/** Printing: what waits to be seen is drawn before, for the width of the paper and in the colours of a light page. */

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
