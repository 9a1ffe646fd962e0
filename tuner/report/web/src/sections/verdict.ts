// The first thing that is read.
import type { ReportData } from "../data";
import { element } from "../dom";
import type { Section } from "./section";

const KINDS: Record<ReportData["kind"], string> = {
  tune: "Tuning run",
  simulate: "Simulation",
  pareto: "Trade-off front",
  robustness: "Robustness",
  compare: "Comparison",
};

export function verdictSection(data: ReportData): Section {
  const details = element("ul", { class: "details" });
  for (const detail of data.verdict.details) details.append(element("li", {}, detail));
  const root = element(
    "section",
    { id: "verdict", class: "verdict", "aria-labelledby": "verdict-heading" },
    element("p", { class: "kind" }, `${KINDS[data.kind] ?? data.kind} · ${data.title} · ${data.robot.name}`),
    element("h1", { id: "verdict-heading" }, data.verdict.sentence),
    data.verdict.details.length > 0 && details,
  );
  return { id: "verdict", short: "Verdict", root };
}
