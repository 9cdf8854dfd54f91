/** Colour map and limits of a layer, to be changed. */
import { colourMaps, type MapKey } from "../colour";
import { button, h, select } from "../dom";
import type { Layer } from "./matrix/layers";
import type { LayerScale } from "./matrix/scale";

const fitting = (value: number): string => String(Number(value.toPrecision(4)));

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
  const { limits } = scale;
  /** Sets limits; where the colours are about zero, both ends move together. Returns whether they can be. */
  const set = (low: number, high: number, larger: number): boolean =>
    (limits.map === "blueWhiteOrange" || limits.map === "purpleGreen") && layer.low < 0
      ? limits.set(-larger, larger)
      : limits.set(low, high);
  const options = layer.maps.map((key): [string, string] => [key, colourMaps[key].name]);
  const map = select({ name: "map" }, options, (key) => {
    limits.map = key as MapKey;
    show();
  }, limits.map);
  const fault = h("p", { class: "note caveat", role: "alert" });
  const unit = layer.unit ? ` (${layer.unit})` : "";
  const number = (end: "low" | "high", name: string) => {
    const label = `${name} of the colours${unit}`;
    const onchange = (input: HTMLInputElement) => {
      const value = input.valueAsNumber;
      const [low, high] = end === "low" ? [value, scale.high] : [scale.low, value];
      const good = set(low, high, Math.abs(value));
      input.setAttribute("aria-invalid", String(!good));
      fault.textContent = good ? "" : "The lower limit must be a number below the upper one.";
      if (good) show();
    };
    return h("input", { type: "number", step: "any", name: end, value: fitting(scale[end]), "aria-label": label, onchange });
  };
  const [low, high] = [number("low", "Lower limit"), number("high", "Upper limit")];
  const show = () => {
    low.value = fitting(scale.low);
    high.value = fitting(scale.high);
    for (const input of [low, high]) input.removeAttribute("aria-invalid");
    map.value = limits.map;
    fault.textContent = "";
    changed();
  };
  const onfit = () => {
    const { low, high } = moment();
    if (set(low, high, Math.max(Math.abs(low), Math.abs(high)))) show();
    else fault.textContent = "At this moment all values are the same.";
  };
  const fit = button("Fit", { name: "fit", title: "Limits that hold all values of this moment", onclick: onfit });
  const onreset = () => {
    limits.reset();
    show();
  };
  const ends = [h("label", {}, "from ", low), h("label", {}, "to ", high), fit, button("Reset", { onclick: onreset })];
  return h("div", { class: "scale-controls" }, h("label", {}, "Colours ", map), h("span", { class: "limits" }, ...ends), fault);
}
