// The trade-off front, two criteria at a time.
import type { Front, ReportData } from "../data";
import { element } from "../dom";
import { formatNumber, formatValue, formatUnit } from "../format";
import { whenVisible } from "../lazy";
import { BLUE, onPage, ORANGE, VERMILLION, withAlpha } from "../palette";
import { Chart, type ChartSeries } from "../plots/chart";
import { legendOf } from "../plots/legend";
import { section, type Section } from "./section";

interface Names {
  heading: string;
  points: string;
}

function chartOf(front: Front, names: Names, xAxis: number, yAxis: number, told: HTMLElement): Chart {
  const points = [...front.points].sort((a, b) => (a.values[xAxis] ?? 0) - (b.values[xAxis] ?? 0));
  const x = points.map((point) => point.values[xAxis] ?? 0);
  const only = (keep: (point: Front["points"][number]) => boolean) =>
    points.map((point) => (keep(point) ? (point.values[yAxis] ?? null) : null));
  const plain = (feasible: boolean) => only((point) => point.role === "point" && point.feasible === feasible);
  const series: ChartSeries[] = [
    { label: "not feasible", colour: () => withAlpha("#888888", 0.7), values: plain(false), marks: 7 },
    { label: names.points, colour: () => onPage(BLUE), values: plain(true), marks: 9 },
    { label: "start", colour: () => onPage(ORANGE), values: only((point) => point.role === "start"), marks: 14 },
    { label: "chosen", colour: () => onPage(VERMILLION), values: only((point) => point.role === "chosen"), marks: 14 },
  ];
  const name = (i: number) => {
    const criterion = front.criteria[i];
    return criterion === undefined ? "" : `${criterion.name} [${formatUnit(criterion.unit) || "1"}]`;
  };
  const span = (x[x.length - 1] ?? 1) - (x[0] ?? 0);
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
      legend: () => series.filter((one) => one.shown !== false).map((one) => ({ label: one.label, colour: one.colour() })),
    },
    legendOf(series, (i, shown) => chart.show(i, shown)),
  );
  const { plot } = chart;
  plot.over.addEventListener("pointermove", (event) => {
    const box = plot.over.getBoundingClientRect();
    let nearest = -1;
    let distance = 30;
    points.forEach((point, i) => {
      const dx = plot.valToPos(x[i] ?? 0, "x") - (event.clientX - box.left);
      const dy = plot.valToPos(point.values[yAxis] ?? 0, "y") - (event.clientY - box.top);
      if (Math.hypot(dx, dy) < distance) [nearest, distance] = [i, Math.hypot(dx, dy)];
    });
    const point = points[nearest];
    if (point === undefined) return;
    const values = front.criteria.map((one, i) => `${one.name} ${formatValue(point.values[i], one.unit)}`);
    told.textContent = `${point.label}${point.feasible ? "" : " (not feasible)"}: ${values.join(", ")}`;
  });
  return chart;
}

function pointTable(front: Front): HTMLElement {
  const head = element("tr", {}, element("th", { scope: "col" }, "point"));
  for (const one of front.criteria) head.append(element("th", { scope: "col", class: "number" }, `${one.name} ${formatUnit(one.unit)}`));
  const body = element("tbody");
  for (const point of front.points) {
    const role = point.role === "point" ? "" : ` (${point.role})`;
    const line = element("tr", {}, element("th", { scope: "row" }, `${point.label}${role}${point.feasible ? "" : ", not feasible"}`));
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
  const told = element("p", { class: "told", role: "status" }, "Point at a mark to read it.");
  // A tuning run has no front but all that its search came by.
  const names: Names =
    data.kind === "pareto"
      ? { heading: "Trade-off front", points: "front" }
      : { heading: "Trade-off among the evaluations", points: "feasible" };
  const axes = [0, 1];
  const make = () => place.replaceChildren(chartOf(front, names, axes[0] ?? 0, axes[1] ?? 1, told).root);
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
    front.criteria.length > 2 && element("p", { class: "choose" }, choose(0, "across"), choose(1, "up")),
    place,
    told,
    pointTable(front),
  );
}
