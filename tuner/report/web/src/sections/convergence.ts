// The search: every evaluation, and the best feasible one so far.
import type { Evaluations, ReportData } from "../data";
import { element } from "../dom";
import { formatNumber } from "../format";
import { whenVisible } from "../lazy";
import { BLUE, GREEN, onPage, ORANGE, VERMILLION, withAlpha } from "../palette";
import { Chart, type Band, type ChartSeries } from "../plots/chart";
import { bestSoFar, phaseRuns } from "../plots/evaluations";
import { legendOf } from "../plots/legend";
import { section, type Section } from "./section";

/** Objectives that span more than this are read better on a logarithmic axis. */
const LOG_FROM = 30;

function chartOf(evaluations: Evaluations): HTMLElement {
  const { objective, feasible, start, chosen } = evaluations;
  const only = (keep: (i: number) => boolean) => objective.map((value, i) => (value !== null && keep(i) ? value : null));
  const series: ChartSeries[] = [
    { label: "not feasible", colour: () => withAlpha("#888888", 0.85), values: only((i) => feasible[i] !== true), marks: 5 },
    { label: "feasible", colour: () => onPage(BLUE), values: only((i) => feasible[i] === true), marks: 6 },
    { label: "best feasible so far", colour: () => onPage(GREEN), values: bestSoFar(objective, feasible), width: 2, stepped: true },
    { label: "start", colour: () => onPage(ORANGE), values: only((i) => i === start), marks: 12 },
    { label: "chosen", colour: () => onPage(VERMILLION), values: only((i) => i === chosen), marks: 12 },
  ];
  const values = objective.filter((value): value is number => value !== null);
  const runs = phaseRuns(evaluations);
  const bands = (): Band[] =>
    // Every other phase; of two, the first is the start alone and needs none.
    runs.filter((_, i) => runs.length > 2 && i % 2 === 1).map((run) => ({ from: run.from - 0.5, to: run.to + 0.5, colour: withAlpha("#888888", 0.12) }));
  const chart: Chart = new Chart(
    {
      title: "Objective of every evaluation",
      file: "convergence",
      xLabel: "evaluation",
      yLabel: "objective [1]",
      height: 280,
      x: objective.map((_, i) => i),
      xPad: 0.5,
      series,
      bands,
      yLog: values.length > 0 && Math.min(...values) > 0 && Math.max(...values) / Math.min(...values) > LOG_FROM,
      legend: () => series.filter((one) => one.shown !== false).map((one) => ({ label: one.label, colour: one.colour() })),
    },
    legendOf(series, (i, shown) => chart.show(i, shown)),
  );
  return chart.root;
}

export function convergenceSection(data: ReportData): Section | null {
  const evaluations = data.evaluations;
  if (evaluations === undefined || evaluations.objective.length === 0) return null;
  const place = element("div", { class: "plot-place tall" });
  whenVisible(place, () => place.replaceWith(chartOf(evaluations)));
  const phases = phaseRuns(evaluations)
    .map((run) => `${run.phase} ${run.to - run.from + 1}`)
    .slice(0, 12)
    .join(", ");
  const feasible = evaluations.feasible.filter(Boolean).length;
  const value = (i: number) => formatNumber(evaluations.objective[i] ?? null);
  return section(
    "convergence",
    "Convergence",
    "The search",
    element(
      "p",
      { class: "note" },
      `${evaluations.objective.length} evaluations, ${feasible} feasible (${phases}). Objective: ${value(evaluations.start)} at the start, ${value(evaluations.chosen)} chosen.`,
    ),
    place,
  );
}
