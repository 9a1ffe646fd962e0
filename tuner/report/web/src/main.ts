// Reads the data in the page and makes the sections of the report, from top to bottom.
import type { ReportData } from "./data";
import { element } from "./dom";
import { liveLine, reloadLater } from "./live";
import { calibrationSection } from "./sections/calibration";
import { convergenceSection } from "./sections/convergence";
import { frontSection } from "./sections/front";
import { gainsSection } from "./sections/gains";
import { marginsSection } from "./sections/margins";
import { planSection } from "./sections/plan";
import { provenanceSection } from "./sections/provenance";
import { robustnessSection } from "./sections/robustness";
import { scenariosSection } from "./sections/scenarios";
import type { Section } from "./sections/section";
import { sensitivitySection } from "./sections/sensitivity";
import { tablesSection } from "./sections/tables";
import { validationSection } from "./sections/validation";
import { verdictSection } from "./sections/verdict";
import { yardstickSection } from "./sections/yardstick";
import { themeButton } from "./theme";

const FORMAT = 1;

function readData(): ReportData {
  const text = document.getElementById("report-data")?.textContent;
  if (text === null || text === undefined) throw new Error("the page contains no data");
  const data = JSON.parse(text) as ReportData;
  if (data.format !== FORMAT) throw new Error(`the data have format ${String(data.format)}, but this page reads format ${FORMAT}`);
  return data;
}

function contents(sections: Section[]): HTMLElement {
  const list = element("ul");
  for (const one of sections) list.append(element("li", {}, element("a", { href: `#${one.id}` }, one.short)));
  return element("nav", { "aria-label": "Contents" }, list);
}

function show(data: ReportData): void {
  document.title = `${data.title} – armtune`;
  const sections = [
    verdictSection(data),
    tablesSection(data),
    frontSection(data),
    planSection(data),
    validationSection(data),
    calibrationSection(data),
    scenariosSection(data),
    convergenceSection(data),
    gainsSection(data),
    sensitivitySection(data),
    robustnessSection(data),
    marginsSection(data),
    yardstickSection(data),
    provenanceSection(data),
  ].filter((one): one is Section => one !== null);
  document.getElementById("top")?.append(contents(sections), themeButton());
  const page = document.getElementById("page");
  page?.replaceChildren(...sections.map((one) => one.root));
  if (data.live === undefined) return;
  page?.prepend(liveLine(data.live));
  reloadLater(data.live);
}

try {
  show(readData());
} catch (error) {
  const words = `This report cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
  document.getElementById("page")?.replaceChildren(element("p", { class: "trouble", role: "alert" }, words));
}
