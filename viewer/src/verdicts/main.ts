/** The page of verdicts: of `matrigrate validate` on verification cases, of `matrigrate reproduce` on the paper's claims. */
import { factList, fault, h, section, table } from "../dom";
import { embedded } from "../embedded";
import { pretty, readable } from "../numbers";
import "../page.css";
import { verdict } from "../study/lists";
import "../study/study.css";
import type { Check, Statement, VerdictPage } from "./contract";
import { picture, plot, studyId, studySection } from "./plots";
import { lettered, units } from "../words";
import "./verdicts.css";

const statementId = (s: Statement): string => `row-${s.id}`;

const badge = (s: Statement): HTMLElement =>
  h(
    "span",
    {},
    verdict(s.verdict),
    s.caveat ? h("span", { class: "caveat" }, ` ${s.caveat}`) : null,
  );

/** Columns that no statement has anything for are left out. */
function overview(page: VerdictPage): HTMLElement {
  const text = (of: (s: Statement) => string) => (s: Statement) => pretty(of(s));
  const columns: [head: string, cell: (s: Statement) => string | HTMLElement][] = [
    ["id", (s) => h("span", {}, h("a", { href: `#${statementId(s)}` }, s.id), s.kind ? ` ${s.kind}` : "")],
    ["statement", text((s) => s.sentence)],
    ["verdict", badge],
    ["published", text((s) => s.published)],
    ["ours", text((s) => s.brief)],
    ["why not", text((s) => s.why_not)],
  ];
  const shown = columns.filter(([, cell]) => page.statements.some((s) => cell(s) !== ""));
  return table(
    shown.map(([head]) => head),
    page.statements.map((s) => shown.map(([, cell]) => cell(s))),
    { caption: "Verdicts" },
  );
}

const bounds = { near: "", at_least: "at least ", at_most: "at most " };

function checks(title: string, list: Check[]): HTMLElement | null {
  if (list.length === 0) return null;
  const made = table(
    ["quantity", "measured", "expected", "tolerance", "verdict", "why this tolerance"],
    list.map((c) => [
      h("span", {}, ...lettered(units(c.quantity))),
      readable(c.measured, 5),
      `${bounds[c.sense]}${readable(c.expected, 5)}`,
      c.sense === "near" ? readable(c.tolerance) : "none",
      verdict(c.holds ? "holds" : "does not hold"),
      pretty(c.reason),
    ]),
    { caption: title },
  );
  made.classList.add("checks");
  return made;
}

function statement(s: Statement, names: string[]): HTMLElement {
  const studies = s.studies.filter((name) => names.includes(name));
  const links = studies.flatMap((name, i) => [i > 0 ? ", " : "", h("a", { href: `#${studyId(name)}` }, name)]);
  const figures = [...s.plots.map(plot), ...s.pictures.map(picture)];
  return section(
    statementId(s),
    `${s.id}: ${pretty(s.sentence)}`,
    h("p", {}, "Verdict: ", badge(s)),
    s.published ? h("p", {}, `Published: ${pretty(s.published)}`) : null,
    checks("Checks", s.checks),
    s.claims.length > 0 ? h("h3", {}, "The paper's claims") : null,
    checks("The paper's claims", s.claims),
    ...s.details.flatMap((d) => [
      h("h3", {}, d.name),
      h("ul", {}, ...d.sentences.map((text) => h("li", {}, pretty(text)))),
    ]),
    links.length > 0 ? h("p", {}, "Runs: ", ...links) : null,
    figures.length > 0 ? h("div", { class: "boxes curves" }, ...figures) : null,
  );
}

function show(page: VerdictPage, place: HTMLElement): void {
  document.title = page.title;
  const count = (word: Statement["verdict"]) => page.statements.filter((s) => s.verdict === word).length;
  const told = (word: Statement["verdict"]) => (count(word) > 0 ? [`${count(word)} ${word}`] : []);
  const names = page.studies.map((one) => one.name);
  place.replaceChildren(
    h(
      "header",
      {},
      h("h1", {}, page.title),
      h(
        "p",
        { class: "status" },
        [`${count("holds")} of ${page.statements.length} hold`, ...told("in direction"), ...told("undecided")].join(", ") + ".",

      ),
      factList(page.facts),
      page.setting
        ? h("p", { class: page.statements.some((s) => s.caveat) ? "notice" : undefined }, pretty(page.setting))
        : null,
    ),
    section("claims", "Verdicts", overview(page)),
    ...page.statements.map((s) => statement(s, names)),
    ...page.studies.map((one) => studySection(one.name, one.study)),
    section("provenance", "Provenance", h("pre", {}, page.provenance)),
    section("citation", "To cite", h("p", { class: "citation" }, page.citation)),
  );
}

const place = document.getElementById("page");
if (place) {
  try {
    show(embedded("matrigrate-verdicts", ["facts", "statements", "studies"]) as unknown as VerdictPage, place);
  } catch (reason) {
    place.replaceChildren(fault(reason instanceof Error ? reason.message : String(reason)));
  }
  document.documentElement.dataset["ready"] = "true";
}
