// The section about a plan: its active limits, the used share of every limit, and how well it was solved.
import type { PlanLimit, ReportData } from "../data";
import { breakable, element, type Child } from "../dom";
import { formatNumber, formatPercent, withUnit } from "../format";
import { boundWords } from "../plots/limit_lines";
import { section, type Section } from "./section";

/** Returns a share of a limit, in percent with two decimals, to distinguish 100 % from a little more. */
const share = (value: number | null) => (value === null ? "–" : formatPercent(value, 2));

/** Returns, for example, "0.015 to 0.136 s", and the number of further time intervals. */
export function stretchWords(limit: Pick<PlanLimit, "active_lower" | "active_upper">): string {
  const MOST = 3;
  const all = [...limit.active_lower, ...limit.active_upper].sort((a, b) => a[0] - b[0]);
  const told = all.slice(0, MOST).map(([from, to]) => (from === to ? `at ${from.toFixed(3)}` : `${from.toFixed(3)} to ${to.toFixed(3)}`));
  const more = all.length > MOST ? ` and ${all.length - MOST} more` : "";
  return told.length === 0 ? "" : `${told.join(", ")} s${more}`;
}

/** Returns the limits that restrict the plan, the strongest first. */
export function binding(limits: PlanLimit[]): PlanLimit[] {
  return limits.filter((limit) => limit.strength > 0).sort((a, b) => b.strength - a.strength);
}

function table(label: string, head: [string, boolean][], rows: Child[][]): HTMLElement {
  const top = element("tr");
  for (const [name, number] of head) top.append(element("th", { scope: "col", class: number && "number" }, name));
  const body = element("tbody");
  for (const row of rows) {
    const line = element("tr");
    row.forEach((cell, i) => line.append(element(i === 0 ? "th" : "td", i === 0 ? { scope: "row" } : { class: (head[i]?.[1] ?? false) && "number" }, cell)));
    body.append(line);
  }
  return element(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": label },
    element("table", {}, element("thead", {}, top), body),
  );
}

const nameOf = (limit: PlanLimit) => breakable(limit.words);

function bindingTable(limits: PlanLimit[]): HTMLElement {
  const strongest = limits[0]?.strength ?? 1;
  return table(
    "Active limits",
    [["limit", false], ["value", true], ["active at", true], ["when", false], ["weight", true]],
    limits.map((limit) => [
      nameOf(limit),
      boundWords(limit),
      `${formatPercent(limit.active)} of the knots`,
      stretchWords(limit),
      formatPercent(limit.strength / strongest),
    ]),
  );
}

function allTable(limits: PlanLimit[]): HTMLElement {
  return table(
    "Every limit",
    [["limit", false], ["value", true], ["used at knots", true], ["between knots", true]],
    limits.map((limit) => [nameOf(limit), boundWords(limit), share(limit.at_knots), share(limit.between_knots)]),
  );
}

export function planSection(data: ReportData): Section | null {
  const { plan } = data;
  if (plan === undefined) return null;
  const limits = data.scenarios[0]?.limits ?? [];
  const active = binding(limits);
  const figures = element("dl", { class: "figures" });
  for (const [name, value] of plan.figures) figures.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
  return section(
    "plan",
    "Limits",
    "Limits of the plan",
    active.length > 0
      ? bindingTable(active)
      : element("p", { class: "note" }, "No limit is active: a wider limit would not improve the plan."),
    active.length > 0 &&
      element("p", { class: "note" }, "Weight: how much the plan would improve if the limit were slightly wider, compared with the first limit of the table (100 %)."),
    element(
      "details",
      {},
      element("summary", {}, "Every limit, at the knots and between them"),
      element("p", { class: "note" }, "Limits are enforced at the knots. Velocity and acceleration limits also hold between them."),
      allTable(limits),
    ),
    figures,
    element("p", { class: "note" }, `Time 0 s on this page is ${withUnit(formatNumber(plan.start, 6), "s")} in the scenario ${plan.scenario}.`),
  );
}
