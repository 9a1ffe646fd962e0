// The section with the metrics before and after, scenario by scenario.
import type { MetricRow, ReportData, Table } from "../data";
import { breakable, element, type Child } from "../dom";
import { changeOf, formatNumber, formatRatio, ratioOf, formatUnit, type Change } from "../format";
import { section, type Section } from "./section";

/** Words beside the ratio, so that the reader does not depend on colours. */
const WORDS: Record<Change, string> = { better: "better", worse: "worse", same: "same", none: "" };

/** Returns the ratio of a set to the first one, and the kind of the change. */
function ratioParts(row: MetricRow, set: number): { kind: Change; parts: Child[] } {
  const [before, after] = [row.values[0], row.values[set]];
  const kind = changeOf(before, after, row.better);
  const ratio = ratioOf(before, after);
  const text = kind === "none" || ratio !== null ? formatRatio(ratio) : "";
  return { kind, parts: [text, element("span", { class: "way" }, WORDS[kind])] };
}

/** Returns the cell of a value. With more than two sets, the ratio is below the value; with two, it has a
 * column of its own. */
function valueCell(row: MetricRow, set: number, withRatio: boolean): HTMLElement {
  const text = row.text?.[set] ?? "";
  const ratio = withRatio && row.values[set] !== null ? ratioParts(row, set) : null;
  return element(
    "td",
    { class: "number" },
    formatNumber(row.values[set]),
    ratio !== null && element("span", { class: `under ratio ${ratio.kind}` }, ...ratio.parts),
    text !== "" && element("span", { class: "aside" }, text),
  );
}

function ratioCell(row: MetricRow): HTMLElement {
  const { kind, parts } = ratioParts(row, row.values.length - 1);
  return element("td", { class: `number ratio ${kind}` }, ...parts);
}

function rowName(row: MetricRow): HTMLElement {
  return element(
    "th",
    { scope: "row", title: row.meaning },
    row.words === "" ? breakable(row.metric) : row.words,
    element("span", { class: "unit" }, formatUnit(row.unit)),
    row.words !== "" && element("span", { class: "aside metric" }, breakable(row.metric)),
  );
}

/** Returns a line for each set that did not complete: when, where and why. */
function troublesOf(table: Table, sets: string[]): HTMLElement[] {
  return table.status.flatMap((status, set) => {
    if (status === "completed" || status === "") return [];
    const reason = table.reason[set] ?? "";
    const who = sets.length > 1 ? `${sets[set] ?? ""}: ` : "";
    return [element("p", { class: "status" }, `${who}${reason === "" ? status : reason}`)];
  });
}

function tableOf(table: Table, sets: string[], heading: "h3" | "h4"): HTMLElement {
  const head = element("tr", {}, element("th", { scope: "col" }, "metric"));
  for (const set of sets) head.append(element("th", { scope: "col", class: "number" }, set));
  if (sets.length === 2) head.append(element("th", { scope: "col", class: "number" }, "ratio"));
  const body = element("tbody");
  for (const row of table.rows) {
    if (row.values.every((value) => value === null)) continue;
    const line = element("tr", {}, rowName(row));
    sets.forEach((_, set) => line.append(valueCell(row, set, sets.length > 2 && set > 0)));
    if (sets.length === 2) line.append(ratioCell(row));
    body.append(line);
  }
  return element(
    "article",
    { class: "card" },
    element(heading, {}, table.scenario),
    ...troublesOf(table, sets),
    element(
      "div",
      { class: "scroll", tabindex: 0, role: "region", "aria-label": `Numbers of ${table.scenario}` },
      element("table", { class: `numbers sets-${Math.min(sets.length, 4)}` }, element("thead", {}, head), body),
    ),
  );
}

function cardsOf(tables: Table[], sets: string[], heading: "h3" | "h4"): HTMLElement {
  const wide = sets.length > 2 ? "cards wide" : "cards";
  return element("div", { class: wide }, ...tables.map((table) => tableOf(table, sets, heading)));
}

export function tablesSection(data: ReportData): Section | null {
  const { judged, sets, tables } = data;
  if (tables.length === 0 && judged === undefined) return null;
  const first = sets[0] ?? "";
  const last = sets[sets.length - 1] ?? "";
  const headings = ["Numbers, scenario by scenario", "Numbers, scenario by scenario", `${first} and ${last}, scenario by scenario`];
  const note =
    sets.length > 2
      ? `Below each value: its ratio to the value of ${first}. Each metric defines whether less or more is better.`
      : `Ratio: ${last} divided by ${first}. Each metric defines whether less or more is better.`;
  return section(
    "numbers",
    "Numbers",
    headings[sets.length] ?? `${sets.length} gain sets, scenario by scenario`,
    sets.length > 1 && element("p", { class: "note" }, note),
    judged !== undefined && element("h3", { class: "group" }, `All arms of the study: ${judged.measure}`),
    judged !== undefined && cardsOf(judged.tables, sets, "h4"),
    judged !== undefined && tables.length > 0 && element("h3", { class: "group" }, "Nominal arm only"),
    cardsOf(tables, sets, judged === undefined ? "h3" : "h4"),
  );
}
