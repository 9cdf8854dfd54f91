/** Reads the data that the program put into the page, and says plainly what is wrong with it. */
import type { RunPage } from "./contract";

export const dataElementId = "matrigrate-data";

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** Data of a format with these lists. Throws an Error whose message can be shown as it is. */
export function embedded(format: string, lists: string[]): Record<string, unknown> {
  const text = document.getElementById(dataElementId)?.textContent ?? "";
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch (fault) {
    throw new Error(
      `The data in this page is not valid JSON: ${fault instanceof Error ? fault.message : String(fault)}.`,
    );
  }
  if (data === null) throw new Error("This page is an empty template: no data has been put into it.");
  if (!isRecord(data)) throw new Error("The data in this page is not an object.");
  if (data["format"] !== format)
    throw new Error(`This page shows data of the format '${format}'; it holds '${String(data["format"])}'.`);
  if (data["version"] !== 1)
    throw new Error(`This page understands version 1 of its data; it holds version ${String(data["version"])}.`);
  const missing = lists.filter((key) => !Array.isArray(data[key]));
  if (missing.length > 0) throw new Error(`The data in this page lacks: ${missing.join(", ")}.`);
  return data;
}

export function embeddedRun(): RunPage {
  const data = embedded("matrigrate-run", ["facts", "protrusions", "readouts", "parameters", "health"]);
  const tracks = data["tracks"];
  if (!isRecord(tracks) || !Array.isArray(tracks["t_s"])) throw new Error("The data in this page lacks: tracks.");
  if (!isRecord(data["geometry"])) throw new Error("The data in this page lacks: geometry.");
  return data as unknown as RunPage;
}
