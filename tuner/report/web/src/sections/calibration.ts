// The section about a calibration: the parameters of the arm before and after the fit, and the errors of
// simulated motion on the held-out part of the log against the time ahead.
import type { CalibratedParameter, HeldOutJoint, ReportData } from "../data";
import { breakable, element } from "../dom";
import { fileName, formatNumber, formatUnit } from "../format";
import { BLUE, onPage, ORANGE } from "../palette";
import type { Chart, ChartSeries } from "../plots/chart";
import { chartOf, later } from "../plots/later_chart";
import { section, type Section } from "./section";

/** Returns the cells of a row behind the name: before, after, interval, and whether the log tells the parameter. */
export function cellsOf(one: CalibratedParameter): string[] {
  return [
    formatNumber(one.before),
    one.kept ? "kept" : formatNumber(one.after),
    `${formatNumber(one.low, 3)} to ${formatNumber(one.high, 3)}`,
    one.told ? "yes" : `no; needed: ${one.motion ?? "another motion"}`,
  ];
}

function table(parameters: CalibratedParameter[]): HTMLElement {
  const top = element("tr");
  ["parameter", "robot file", "calibrated", "95 % interval", "told by the log?"].forEach((head, i) =>
    top.append(element("th", { scope: "col", class: i > 0 && i < 4 && "number" }, head)),
  );
  const body = element("tbody");
  for (const one of parameters) {
    const name = element("th", { scope: "row" }, breakable(one.name), element("span", { class: "unit" }, formatUnit(one.unit)));
    const cells = cellsOf(one).map((text, i) => element("td", { class: i < 3 ? "number" : !one.told && "same" }, text));
    body.append(element("tr", {}, name, ...cells));
  }
  return element(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": "Parameters" },
    element("table", {}, element("thead", {}, top), body),
  );
}

function errorChart(one: HeldOutJoint, horizons: number[]): Chart {
  const series: ChartSeries[] = [
    { label: "robot file", colour: () => onPage(ORANGE), values: one.before, dash: [8, 3], width: 1.5 },
    { label: "calibrated", colour: () => onPage(BLUE), values: one.after, width: 2 },
  ];
  return chartOf(one.joint, fileName("held_out", one.joint), "time ahead [s]", "RMS error [rad, m]", horizons, series, [0]);
}

export function calibrationSection(data: ReportData): Section | null {
  const { calibration } = data;
  if (calibration === undefined) return null;
  const { parameters, joints, windows } = calibration;
  const horizons = calibration.horizons.map((one) => one ?? NaN);
  const charts: Chart[] = [];
  const counts = horizons.map((horizon, i) => `${windows[i] ?? 0} reach ${horizon} s`).join(", ");
  return section(
    "calibration",
    "Calibration",
    "The arm as the log shows it",
    parameters.length > 0 && table(parameters),
    parameters.length > 0 &&
      element(
        "p",
        { class: "note" },
        "The log tells a parameter if it at least halves the width of what was known before. Kept: the log says next to nothing, and the calibrated arm has the value of the robot file.",
      ),
    joints.length > 0 && element("h3", {}, "Error on the held-out part of the log"),
    joints.length > 0 && element("p", { class: "note" }, `Windows of the part that was not fitted: ${counts}.`),
    joints.length > 0 && element("div", { class: "time-plots" }, ...joints.map((one) => later(() => errorChart(one, horizons), charts))),
  );
}
