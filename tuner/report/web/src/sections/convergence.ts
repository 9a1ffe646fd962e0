// The section with the search: every evaluation, and the best feasible one so far.
import type { Evaluations, ReportData } from "../data";
import { element } from "../dom";
import { formatNumber } from "../format";
import { whenVisible } from "../lazy";
import { BLUE, GREEN, onPage, ORANGE, VERMILLION, withAlpha } from "../palette";
import type { Band } from "../plots/backdrop";
import { Chart, type ChartSeries } from "../plots/chart";
import { bestLine, countsOf, numberOf, phaseRuns, undrawnText } from "../plots/evaluations";
import { legendEntries, legendOf } from "../plots/legend";
import { readMarks, type Mark } from "../plots/read_marks";
import { section, type Section } from "./section";

/** If the largest objective is more than this many times the smallest, the axis is logarithmic. */
const LOG_FROM = 30;

function seriesOf(evaluations: Evaluations): ChartSeries[] {
  const { objective, feasible, native, start, chosen } = evaluations;
  const only = (keep: (i: number) => boolean) => objective.map((value, i) => (value !== null && keep(i) ? value : null));
  const of = (isNative: boolean, isFeasible: boolean) =>
    only((i) => (native?.[i] === true) === isNative && (feasible[i] === true) === isFeasible);
  const best = bestLine(evaluations);
  const grey = (alpha: number) => () => withAlpha("#888888", alpha);
  return [
    { label: "infeasible, in the native engine", colour: grey(0.4), values: of(true, false), marks: 5, shape: "cross" },
    { label: "feasible, in the native engine", colour: () => withAlpha(onPage(BLUE), 0.4), values: of(true, true), marks: 4 },
    { label: "infeasible", colour: grey(0.85), values: of(false, false), marks: 6, shape: "cross" },
    { label: "feasible", colour: () => onPage(BLUE), values: of(false, true), marks: 6 },
    { label: best.label, colour: () => onPage(GREEN), values: best.values, width: 2, stepped: true },
    { label: "start", colour: () => onPage(ORANGE), values: only((i) => i === start), marks: 14, shape: "ring" },
    { label: "chosen", colour: () => onPage(VERMILLION), values: only((i) => i === chosen), marks: 13, shape: "diamond" },
  ];
}

function marksOf(evaluations: Evaluations, series: ChartSeries[]): Mark[] {
  const { objective, feasible, native, violation, phase, of, start, chosen } = evaluations;
  return objective.flatMap((value, i): Mark[] => {
    if (value === null) return [];
    const missed = violation[i] ?? null;
    const parts = [
      phase[of[i] ?? -1] ?? "",
      i === start ? "the start" : "",
      i === chosen ? "chosen" : "",
      native?.[i] === true ? "in the native engine" : "",
      feasible[i] === true ? "feasible" : `infeasible${missed === null ? "" : `, violation ${formatNumber(missed)}`}`,
    ];
    // The series of marks that contains the evaluation, not the line of the best.
    const own = series.findIndex((one) => one.marks !== undefined && one.values[i] !== null);
    const text = `Evaluation ${numberOf(evaluations, i)}: objective ${formatNumber(value)} (${parts.filter((part) => part !== "").join(", ")})`;
    return [{ x: numberOf(evaluations, i), y: value, series: own, text }];
  });
}

function chartOf(evaluations: Evaluations, told: HTMLElement): HTMLElement {
  const { objective } = evaluations;
  const series = seriesOf(evaluations);
  const values = objective.filter((value): value is number => value !== null);
  const runs = evaluations.thinned?.more_phase_runs === true ? [] : phaseRuns(evaluations);
  const bands = (): Band[] =>
    // Every second phase has a band. With only two phases, the first is the start alone, and there are no
    // bands.
    runs.filter((_, i) => runs.length > 2 && i % 2 === 1).map((run) => ({ from: run.from - 0.5, to: run.to + 0.5, colour: withAlpha("#888888", 0.12) }));
  const chart: Chart = new Chart(
    {
      title: "Objective of every evaluation",
      file: "convergence",
      xLabel: "evaluation",
      yLabel: "objective [1]",
      height: 280,
      x: objective.map((_, i) => numberOf(evaluations, i)),
      xPad: 0.5,
      series,
      bands,
      yLog: values.length > 0 && Math.min(...values) > 0 && Math.max(...values) / Math.min(...values) > LOG_FROM,
      legend: () => legendEntries(series),
    },
    legendOf(series, (i, shown) => chart.show(i, shown)),
  );
  readMarks(chart, marksOf(evaluations, series), told);
  return chart.root;
}

export function convergenceSection(data: ReportData): Section | null {
  const evaluations = data.evaluations;
  if (evaluations === undefined || evaluations.objective.length === 0) return null;
  const place = element("div", { class: "plot-place tall" });
  const told = element("p", { class: "told", role: "status" }, "Point at a mark to read it, or step through the marks with ← and →.");
  whenVisible(place, () => place.replaceWith(chartOf(evaluations, told)));
  const phases = phaseRuns(evaluations)
    .map((run) => `${run.phase} ${run.to - run.from + 1}`)
    .slice(0, 12)
    .join(", ");
  const { total, feasible, native, undrawn } = countsOf(evaluations);
  const shown = evaluations.objective.length;
  const value = (i: number) => formatNumber(evaluations.objective[i] ?? null);
  const counts = [
    `${total} evaluations`,
    shown < total ? `the plot shows ${shown} of them, the best and the worst of every ${Math.ceil(total / 6000)}` : "",
    native > 0 ? `${native} of them in the native engine` : "",
    `${feasible} feasible in total (evaluations in each phase: ${phases})`,
    undrawnText(undrawn),
  ];
  return section(
    "convergence",
    "Convergence",
    "The search",
    element(
      "p",
      { class: "note" },
      `${counts.filter((part) => part !== "").join(", ")}. Objective: ${value(evaluations.start)} at the start, ${value(evaluations.chosen)} with the chosen gains.`,
    ),
    place,
    told,
  );
}
