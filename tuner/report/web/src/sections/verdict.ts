// The first section: the verdict of the run.
import type { ReportData } from "../data";
import { element } from "../dom";
import { unbroken } from "../format";
import type { Section } from "./section";

/** A sentence with more characters has smaller letters, so that the numbers below it stay in view. */
const LONG = 140;

export function verdictSection(data: ReportData): Section {
  const details = element("ul", { class: "details" });
  for (const detail of data.verdict.details) details.append(element("li", {}, unbroken(detail)));
  const root = element(
    "section",
    { id: "verdict", class: "verdict", "aria-labelledby": "verdict-heading" },
    element("p", { class: "kind" }, [data.title, data.robots[0]?.name ?? ""].filter((part) => part !== "").join(" · ")),
    element("h1", { id: "verdict-heading", elementtiming: "verdict", class: data.verdict.sentence.length > LONG && "long" }, unbroken(data.verdict.sentence)),
    data.verdict.details.length > 0 && details,
  );
  return { id: "verdict", short: "Verdict", root };
}
