// The section with the stability margins of each gain set.
import type { Margin, ReportData } from "../data";
import { breakable, element } from "../dom";
import { formatUnit } from "../format";
import { section, type Section } from "./section";

function table(margins: Margin[], sets: string[], withScenario: boolean): HTMLElement {
  const head = element("tr", {}, element("th", { scope: "col" }, "margin"));
  if (withScenario) head.append(element("th", { scope: "col" }, "scenario"));
  for (const set of sets) head.append(element("th", { scope: "col" }, set));
  const body = element("tbody");
  for (const margin of margins) {
    const line = element(
      "tr",
      {},
      element("th", { scope: "row" }, breakable(margin.margin), element("span", { class: "unit" }, formatUnit(margin.unit))),
    );
    if (withScenario) line.append(element("td", {}, breakable(margin.scenario)));
    sets.forEach((_, set) => {
      const reason = margin.reason[set] ?? "";
      line.append(
        element("td", {}, element("b", {}, (margin.text[set] ?? "") || "–"), reason !== "" && element("span", { class: "aside" }, breakable(reason))),
      );
    });
    body.append(line);
  }
  return element(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": "Margins" },
    element("table", { class: "margins" }, element("thead", {}, head), body),
  );
}

export function marginsSection(data: ReportData): Section | null {
  const margins = data.margins ?? [];
  if (margins.length === 0) return null;
  const all = margins.filter((margin) => margin.scenario === "all");
  const single = margins.filter((margin) => margin.scenario !== "all");
  return section(
    "margins",
    "Margins",
    "Stability margins, and what breaks first",
    all.length > 0 ? table(all, data.sets, false) : table(single, data.sets, true),
    all.length > 0 &&
      single.length > 0 &&
      element("details", {}, element("summary", {}, "Scenario by scenario"), table(single, data.sets, true)),
  );
}
