// The section about a validation: measured torques beside those that the robot file predicts, and the errors
// of simulated motion against the time ahead.
import type { ReportData, Validation, ValidatedMotion, ValidatedTorque } from "../data";
import { decodeSeries } from "../decode";
import { breakable, element } from "../dom";
import { fileName, formatNumber, formatPercent } from "../format";
import { BLUE, onPage, ORANGE, VERMILLION, withAlpha } from "../palette";
import { gaps } from "../plots/align";
import type { Chart, ChartSeries } from "../plots/chart";
import { chartOf, later } from "../plots/later_chart";
import { section, type Section } from "./section";

/** Horizons of the table, s. */
const HORIZONS = [0.1, 0.5, 1, 2];

/** Returns the value at the horizon nearest to `time`; null if there is none within a step of the horizons. */
export function errorAt(horizons: number[], values: (number | null)[], time: number): number | null {
  const step = (horizons[1] ?? 0) - (horizons[0] ?? 0);
  let nearest = 0;
  horizons.forEach((one, i) => {
    if (Math.abs(one - time) < Math.abs((horizons[nearest] ?? Infinity) - time)) nearest = i;
  });
  return Math.abs((horizons[nearest] ?? Infinity) - time) < step ? (values[nearest] ?? null) : null;
}

function torqueChart(torque: ValidatedTorque, time: number[]): Chart {
  const share = torque.explained === null ? "" : `: ${formatPercent(torque.explained)} explained`;
  const series: ChartSeries[] = [
    { label: "measured", colour: () => onPage(BLUE), values: gaps(decodeSeries(torque.measured)) },
    { label: "predicted", colour: () => onPage(ORANGE), values: gaps(decodeSeries(torque.predicted)) },
    { label: "residual", colour: () => withAlpha(onPage(VERMILLION), 0.8), values: gaps(decodeSeries(torque.residual)), width: 1 },
  ];
  return chartOf(`${torque.joint}${share}`, fileName("torque", torque.joint), "time [s]", "torque [N m, N]", time, series, [0]);
}

function motionChart(motion: ValidatedMotion, horizons: number[]): Chart {
  const bound = () => withAlpha(onPage(BLUE), 0.5);
  const series: ChartSeries[] = [
    { label: "error of the simulation", colour: () => onPage(BLUE), values: motion.rms, width: 2 },
    { label: "lower end of its 95 % interval", colour: bound, values: motion.low, dash: [4, 3], width: 1 },
    { label: "upper end", colour: bound, values: motion.high, dash: [4, 3], width: 1 },
    { label: "without a model", colour: () => onPage(ORANGE), values: motion.yardstick, dash: [8, 3], width: 1.5 },
  ];
  return chartOf(motion.joint, fileName("motion", motion.joint), "time ahead [s]", "RMS error [rad, m]", horizons, series, [0]);
}

function table(validation: Validation): HTMLElement {
  const { torques, motion, horizons } = validation;
  const names = torques.length > 0 ? torques.map((one) => one.joint) : motion.map((one) => one.joint);
  const heads = ["joint"];
  if (torques.length > 0) heads.push("explained", "residual RMS [N m, N]", "torque RMS [N m, N]");
  if (motion.length > 0) heads.push(...HORIZONS.map((time) => `error after ${time} s [rad, m]`));
  const top = element("tr");
  heads.forEach((head, i) => top.append(element("th", { scope: "col", class: i > 0 && "number" }, head)));
  const body = element("tbody");
  for (const name of names) {
    const row = element("tr", {}, element("th", { scope: "row" }, breakable(name)));
    const add = (text: string) => row.append(element("td", { class: "number" }, text));
    const torque = torques.find((one) => one.joint === name);
    if (torque !== undefined) {
      add(torque.explained === null ? "–" : formatPercent(torque.explained));
      add(formatNumber(torque.residual_rms, 3));
      add(formatNumber(torque.torque_rms, 3));
    }
    const moved = motion.find((one) => one.joint === name);
    if (moved !== undefined) for (const time of HORIZONS) add(formatNumber(errorAt(horizons, moved.rms, time), 2));
    body.append(row);
  }
  return element(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": "Joints" },
    element("table", {}, element("thead", {}, top), body),
  );
}

export function validationSection(data: ReportData): Section | null {
  const { validation } = data;
  if (validation === undefined) return null;
  const { torques, motion, horizons, commands, thresholds } = validation;
  const time = Array.from(decodeSeries(validation.time));
  const torqueCharts: Chart[] = [];
  const motionCharts: Chart[] = [];
  const limits = element("dl", { class: "figures" });
  for (const [name, value] of thresholds) limits.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
  return section(
    "validation",
    "Validation",
    "The log beside the robot file",
    (torques.length > 0 || motion.length > 0) && table(validation),
    torques.length > 0 && element("h3", {}, "Torques"),
    torques.length > 0 && element("p", { class: "note" }, "The robot file's torques follow from the logged motion; nothing was fitted."),
    torques.length > 0 && element("div", { class: "time-plots" }, ...torques.map((one) => later(() => torqueChart(one, time), torqueCharts))),
    motion.length > 0 && element("h3", {}, "Motion simulated ahead"),
    motion.length > 0 &&
      element(
        "p",
        { class: "note" },
        `The arm starts from logged states and is moved by the logged commands (${commands}). Without a model: the better of two predictions, that the joint stays or that it keeps its velocity.`,
      ),
    motion.length > 0 && element("div", { class: "time-plots" }, ...motion.map((one) => later(() => motionChart(one, horizons), motionCharts))),
    thresholds.length > 0 && element("details", {}, element("summary", {}, "Thresholds of the verdict"), limits),
  );
}
