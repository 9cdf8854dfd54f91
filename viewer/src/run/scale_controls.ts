/** Colour map and limits of a layer, to be changed. */
import { colourMaps, type MapKey } from "../colour";
import { h } from "../dom";
import type { Layer } from "./matrix/layers";
import type { LayerScale } from "./matrix/scale";

/** True if the colours are about zero; both ends then move together. */
const isAboutZero = (scale: LayerScale, layer: Layer): boolean =>
  (scale.limits.map === "blueWhiteOrange" || scale.limits.map === "purpleGreen") && layer.low < 0;

/** Which limits a person asked for. */
export function asked(scale: LayerScale, layer: Layer, end: "low" | "high", value: number): [number, number] {
  if (isAboutZero(scale, layer)) return [-Math.abs(value), Math.abs(value)];
  return end === "low" ? [value, scale.high] : [scale.low, value];
}

const fitting = (value: number): string => String(Number(value.toPrecision(4)));

/** Limits that hold all values from `low` to `high`. */
export function fitted(scale: LayerScale, layer: Layer, { low, high }: { low: number; high: number }): [number, number] {
  const larger = Math.max(Math.abs(low), Math.abs(high));
  return isAboutZero(scale, layer) ? [-larger, larger] : [low, high];
}

/**
 * @param moment   smallest and largest value at the moment shown
 * @param changed  called after a change, to draw anew
 */
export function scaleControls(
  layer: Layer,
  scale: LayerScale,
  moment: () => { low: number; high: number },
  changed: () => void,
): HTMLElement {
  const map = h(
    "select",
    { name: "map" },
    ...layer.maps.map((key) => h("option", { value: key, selected: key === scale.limits.map }, colourMaps[key].name)),
  );
  const fault = h("p", { class: "note caveat", role: "alert" });
  const unit = layer.unit ? ` (${layer.unit})` : "";
  const number = (end: "low" | "high", name: string) => {
    const input = h("input", {
      type: "number",
      step: "any",
      name: end,
      value: fitting(scale[end]),
      "aria-label": `${name} of the colours${unit}`,
    });
    input.addEventListener("change", () => {
      const value = input.valueAsNumber;
      const good = scale.limits.set(...asked(scale, layer, end, value));
      input.setAttribute("aria-invalid", String(!good));
      fault.textContent = good ? "" : "The lower limit must be a number below the upper one.";
      if (good) show();
    });
    return input;
  };
  const [low, high] = [number("low", "Lower limit"), number("high", "Upper limit")];
  const fit = h("button", { type: "button", name: "fit", title: "Limits that hold all values of this moment" }, "Fit");
  const reset = h("button", { type: "button" }, "Reset");
  const show = () => {
    low.value = fitting(scale.low);
    high.value = fitting(scale.high);
    for (const input of [low, high]) input.removeAttribute("aria-invalid");
    map.value = scale.limits.map;
    fault.textContent = "";
    changed();
  };
  map.addEventListener("change", () => {
    scale.limits.map = map.value as MapKey;
    show();
  });
  fit.addEventListener("click", () => {
    if (scale.limits.set(...fitted(scale, layer, moment()))) show();
    else fault.textContent = "At this moment all values are the same.";
  });
  reset.addEventListener("click", () => {
    scale.limits.reset();
    show();
  });
  return h(
    "div",
    { class: "scale-controls" },
    h("label", {}, "Colours ", map),
    h("span", { class: "limits" }, h("label", {}, "from ", low), h("label", {}, "to ", high), fit, reset),
    fault,
  );
}
