/** Colour map and limits of a layer, to be changed. */
import { colourMaps, type MapKey } from "../colour";
import { h } from "../dom";
import type { Layer } from "./matrix/layers";
import type { LayerScale } from "./matrix/scale";

/** Which limits a person asked for: about zero, where the colours mean that, both ends move together. */
export function asked(scale: LayerScale, layer: Layer, end: "low" | "high", value: number): [number, number] {
  const aboutZero = scale.limits.map === "blueWhiteOrange" || scale.limits.map === "purpleGreen";
  if (aboutZero && layer.low < 0) return [-Math.abs(value), Math.abs(value)];
  return end === "low" ? [value, scale.high] : [scale.low, value];
}

const fitting = (value: number): string => String(Number(value.toPrecision(4)));

/** @param changed  called after a change, to draw anew */
export function scaleControls(layer: Layer, scale: LayerScale, changed: () => void): HTMLElement {
  const map = h(
    "select",
    { name: "map" },
    ...layer.maps.map((key) => h("option", { value: key, selected: key === scale.limits.map }, colourMaps[key].name)),
  );
  const fault = h("p", { class: "note caveat", role: "alert" });
  const unit = layer.unit ? ` [${layer.unit}]` : "";
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
  reset.addEventListener("click", () => {
    scale.limits.reset();
    show();
  });
  return h(
    "div",
    { class: "scale-controls" },
    h("label", {}, "Colours ", map),
    h("span", { class: "limits" }, h("label", {}, "from ", low), h("label", {}, "to ", high), reset),
    fault,
  );
}
