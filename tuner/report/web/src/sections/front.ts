// The section with the trade-off front. It shows two criteria at a time.
import type { Front, ReportData } from "../data";
import { element } from "../dom";
import { formatNumber, formatValue, formatUnit } from "../format";
import { whenVisible } from "../lazy";
import { BLUE, onPage, ORANGE, VERMILLION, withAlpha } from "../palette";
import { Chart, type ChartSeries } from "../plots/chart";
import { legendEntries, legendOf } from "../plots/legend";
import { readMarks } from "../plots/read_marks";
import { section, type Section } from "./section";

interface Names {
  heading: string;
  points: string;
}

type Role = Front["points"][number]["role"];
/** What is added to a point's label. The label of the start says that it is the start. */
const ROLES: Record<Role, string> = { start: "", chosen: "chosen", shown: "shown here", point: "" };

/** A limit farther away than this many times the span of the points is not drawn, because it would leave them
 * no room. A note names it. */
const FAR = 2;

/** Returns the limits of a criterion that are drawn, and those that are too far away. */
export function limitsOf(front: Pick<Front, "limits" | "points">, criterion: number): { near: number[]; far: number[] } {
  const values = front.points.map((point) => point.values[criterion] ?? NaN).filter(Number.isFinite);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const room = FAR * (high - low || Math.abs(high) || 1);
  const all = front.limits.filter((limit) => limit.criterion === criterion).map((limit) => limit.value);
  const isNear = (value: number) => value >= low - room && value <= high + room;
  return { near: all.filter(isNear), far: all.filter((value) => !isNear(value)) };
}

function wordsOf(front: Front, point: Front["points"][number]): string {
  const values = front.criteria.map((one, i) => `${one.name} ${formatValue(point.values[i], one.unit)}`);
  const notes = [ROLES[point.role], point.feasible ? "" : "infeasible"].filter((note) => note !== "");
  return `${point.label}${notes.length > 0 ? ` (${notes.join(", ")})` : ""}: ${values.join(", ")}`;
}

/** Returns, for example, "start (published)" if the run names its start gains. */
function startOf(points: Front["points"]): string {
  return points.find((point) => point.role === "start")?.label ?? "start";
}

function chartOf(front: Front, names: Names, xAxis: number, yAxis: number, told: HTMLElement): Chart {
  const points = [...front.points].sort((a, b) => (a.values[xAxis] ?? 0) - (b.values[xAxis] ?? 0));
  const x = points.map((point) => point.values[xAxis] ?? 0);
  const only = (keep: (point: Front["points"][number]) => boolean) =>
    points.map((point) => (keep(point) ? (point.values[yAxis] ?? null) : null));
  const plain = (feasible: boolean) => only((point) => point.role === "point" && point.feasible === feasible);
  const role = (name: Role) => only((point) => point.role === name);
  const series: ChartSeries[] = [
    { label: "infeasible", colour: () => withAlpha("#888888", 0.7), values: plain(false), marks: 7, shape: "cross" },
    { label: names.points, colour: () => onPage(BLUE), values: plain(true), marks: 9 },
    { label: startOf(points), colour: () => onPage(ORANGE), values: role("start"), marks: 15, shape: "ring" },
    { label: ROLES.chosen, colour: () => onPage(VERMILLION), values: role("chosen"), marks: 14, shape: "diamond" },
    { label: ROLES.shown, colour: () => onPage(VERMILLION), values: role("shown"), marks: 13, shape: "square" },
  ];
  const name = (i: number) => {
    const criterion = front.criteria[i];
    return criterion === undefined ? "" : `${criterion.name} [${formatUnit(criterion.unit) || "1"}]`;
  };
  const lines = ([["x", xAxis], ["y", yAxis]] as const).flatMap(([axis, criterion]) =>
    limitsOf(front, criterion).near.map((value) => ({ axis, value, label: `limit ${formatNumber(value)}` })),
  );
  const ends = [...x, ...lines.filter((line) => line.axis === "x").map((line) => line.value)];
  const span = Math.max(...ends) - Math.min(...ends);
  const chart: Chart = new Chart(
    {
      title: names.heading,
      file: "front",
      xLabel: name(xAxis),
      yLabel: name(yAxis),
      height: 360,
      x,
      xPad: 0.06 * span || 0.05 * Math.abs(x[0] ?? 1),
      series,
      lines,
      legend: () => legendEntries(series),
    },
    legendOf(series, (i, shown) => chart.show(i, shown)),
  );
  const marks = points.map((point, i) => ({
    x: x[i] ?? NaN,
    y: point.values[yAxis] ?? NaN,
    series: series.findIndex((one) => one.values[i] !== null),
    text: wordsOf(front, point),
  }));
  readMarks(chart, marks, told);
  return chart;
}

function pointTable(front: Front): HTMLElement {
  const head = element("tr", {}, element("th", { scope: "col" }, "point"));
  for (const one of front.criteria) head.append(element("th", { scope: "col", class: "number" }, `${one.name} ${formatUnit(one.unit)}`));
  const body = element("tbody");
  for (const point of front.points) {
    const role = ROLES[point.role] === "" ? "" : ` (${ROLES[point.role]})`;
    const line = element("tr", {}, element("th", { scope: "row" }, `${point.label}${role}${point.feasible ? "" : ", infeasible"}`));
    for (const value of point.values) line.append(element("td", { class: "number" }, formatNumber(value)));
    body.append(line);
  }
  return element(
    "details",
    {},
    element("summary", {}, "All points as a table"),
    element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Points of the front" }, element("table", {}, element("thead", {}, head), body)),
  );
}

export function frontSection(data: ReportData): Section | null {
  const front = data.front;
  if (front === undefined || front.criteria.length < 2 || front.points.length === 0) return null;
  const place = element("div", { class: "plot-place tall" });
  const told = element("p", { class: "told", role: "status" }, "Point at a mark to read it, or step through the marks with ← and →.");
  // A tuning run has no front, only the evaluations of its search.
  const names: Names =
    data.kind === "pareto"
      ? { heading: "Trade-off front", points: "front" }
      : { heading: "Trade-off among the evaluations", points: "feasible" };
  const axes = [0, 1];
  const beyond = element("p", { class: "note" });
  const make = () => {
    place.replaceChildren(chartOf(front, names, axes[0] ?? 0, axes[1] ?? 1, told).root);
    const far = axes.flatMap((axis) => {
      const criterion = front.criteria[axis];
      return limitsOf(front, axis).far.map((value) => `${criterion?.name ?? ""} ${formatValue(value, criterion?.unit ?? "1")}`);
    });
    beyond.textContent = far.length > 0 ? `Limits outside the plot: ${far.join(", ")}.` : "";
    beyond.hidden = far.length === 0;
  };
  const choose = (which: number, text: string) => {
    const select = element("select");
    front.criteria.forEach((one, i) => select.append(element("option", { value: i, selected: i === which }, one.name)));
    select.addEventListener("change", () => {
      axes[which] = Number(select.value);
      make();
    });
    return element("label", {}, `${text} `, select);
  };
  whenVisible(place, make);
  return section(
    "front",
    "Trade-off",
    names.heading,
    front.hypervolume !== null && element("p", { class: "note" }, `Hypervolume ${formatNumber(front.hypervolume)}`),
    front.criteria.length > 2 && element("p", { class: "choose" }, choose(0, "horizontal axis"), choose(1, "vertical axis")),
    place,
    beyond,
    told,
    pointTable(front),
  );
}
