// Before and after, scenario by scenario.
import type { MetricRow, ReportData, Table } from "../data";
import { breakable, element } from "../dom";
import { changeOf, formatNumber, formatRatio, ratioOf, formatUnit, type Change } from "../format";
import { section, type Section } from "./section";

const MARKS: Record<Change, { mark: string; words: string }> = {
  better: { mark: "▼", words: "better" },
  worse: { mark: "▲", words: "worse" },
  same: { mark: "=", words: "unchanged" },
  none: { mark: "", words: "" },
};

/** The arrow points the way the number went. */
function markOf(change: Change, before: number, after: number): string {
  if (change !== "better" && change !== "worse") return MARKS[change].mark;
  return after < before ? "▼" : "▲";
}

function valueCell(row: MetricRow, set: number): HTMLElement {
  const text = row.text?.[set] ?? "";
  return element(
    "td",
    { class: "number" },
    formatNumber(row.values[set]),
    text !== "" && element("span", { class: "aside" }, text),
  );
}

function ratioCell(row: MetricRow): HTMLElement {
  const before = row.values[0];
  const after = row.values[row.values.length - 1];
  const change = changeOf(before, after, row.better);
  const ratio = ratioOf(before, after);
  const mark = markOf(change, before ?? 0, after ?? 0);
  const { words } = MARKS[change];
  return element(
    "td",
    { class: `number ratio ${change}` },
    mark === "" || ratio !== null ? formatRatio(ratio) : "",
    element("span", { class: "way", title: words, role: "img", "aria-label": words || "not compared" }, mark),
  );
}

function tableOf(table: Table, sets: string[]): HTMLElement {
  const several = sets.length > 1;
  const head = element("tr", {}, element("th", { scope: "col" }, "metric"));
  for (const set of sets) head.append(element("th", { scope: "col", class: "number" }, set));
  if (several) head.append(element("th", { scope: "col", class: "number" }, "ratio"));
  const body = element("tbody");
  for (const row of table.rows) {
    if (row.values.every((value) => value === null)) continue;
    const line = element(
      "tr",
      {},
      element(
        "th",
        { scope: "row", title: row.meaning },
        breakable(row.metric),
        element("span", { class: "unit" }, formatUnit(row.unit)),
      ),
    );
    sets.forEach((_, set) => line.append(valueCell(row, set)));
    if (several) line.append(ratioCell(row));
    body.append(line);
  }
  const bad = table.status
    .map((status, set) => (status === "completed" || status === "" ? "" : `${sets[set] ?? ""}: ${status}`))
    .filter((text) => text !== "");
  return element(
    "article",
    { class: "card" },
    element("h3", {}, table.scenario, bad.length > 0 && element("span", { class: "status" }, bad.join(", "))),
    element(
      "div",
      { class: "scroll", tabindex: 0, role: "region", "aria-label": `Numbers of ${table.scenario}` },
      element("table", { class: `numbers sets-${Math.min(sets.length, 4)}` }, element("thead", {}, head), body),
    ),
  );
}

export function tablesSection(data: ReportData): Section | null {
  if (data.tables.length === 0) return null;
  const several = data.sets.length > 1;
  const cards = element("div", { class: "cards" });
  for (const table of data.tables) cards.append(tableOf(table, data.sets));
  const first = data.sets[0] ?? "";
  const last = data.sets[data.sets.length - 1] ?? "";
  return section(
    "numbers",
    "Numbers",
    several ? `${first} and ${last}, scenario by scenario` : "Numbers, scenario by scenario",
    several && element("p", { class: "note" }, `Ratio: ${last} over ${first}. `, 
      element("span", { class: "better" }, "▼ ▲ better"), ", ", element("span", { class: "worse" }, "▲ ▼ worse"),
      "; the arrow says which way the number went."),
    cards,
  );
}
