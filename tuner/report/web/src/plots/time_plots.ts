// The time plots of one scenario. They share a time axis and a playhead. Bands show the states of the
// controller.
import type { Run, Scenario } from "../data";
import { element } from "../dom";
import { whenVisible } from "../lazy";
import { SLERP_COLOUR, stateColour, withAlpha } from "../palette";
import type { Playhead } from "../playhead";
import type { Band } from "./backdrop";
import { FIGURES } from "./figures";
import { TimePlot } from "./time_plot";

/** Returns the bands of a run, up to its end: first its states, except following the path, and then its
 * slerps (smooth turns of the tool). */
export function bandsOf(run: Run | undefined, scenario: Scenario): Band[] {
  if (run === undefined) return [];
  const bands: Band[] = [];
  run.states.forEach((change, i) => {
    const colour = stateColour(scenario.states[change.state] ?? "");
    const to = run.states[i + 1]?.t ?? run.end;
    if (colour !== null) bands.push({ from: change.t, to, colour: withAlpha(colour, 0.2) });
  });
  for (const [from, to] of run.slerps) bands.push({ from, to: Math.min(to, run.end), colour: withAlpha(SLERP_COLOUR, 0.28) });
  return bands;
}

export class TimePlots {
  readonly root = element("div", { class: "time-plots" });
  private readonly plots: TimePlot[] = [];
  private zoom: [number, number] | null = null;

  constructor(
    scenario: Scenario,
    sets: string[],
    private readonly shownRun: () => Run | undefined,
    isShown: (set: number) => boolean,
    playhead: Playhead,
  ) {
    for (const figure of FIGURES) {
      if (!scenario.runs.some((run) => run.columns.some((column) => column.group === figure.group))) continue;
      const place = element("div", { class: "plot-place" });
      this.root.append(place);
      whenVisible(place, () => {
        const bands = () => bandsOf(this.shownRun(), scenario);
        const plot = new TimePlot(figure, scenario, sets, isShown, playhead, bands);
        place.replaceWith(plot.chart.root);
        if (this.zoom !== null) plot.chart.setRange(...this.zoom);
        plot.chart.onZoom = (from, to) => this.zoomAll(plot, from, to);
        this.plots.push(plot);
      });
    }
  }

  refresh(): void {
    for (const plot of this.plots) plot.refresh();
  }

  /** Zooms by buttons, because dragging scrolls on touch screens. factor: null shows all. */
  zoomBy(factor: number | null): void {
    const [first] = this.plots;
    if (factor === null) first?.chart.showAll();
    else first?.chart.zoomBy(factor);
  }

  private zoomAll(by: TimePlot, from: number, to: number): void {
    this.zoom = [from, to];
    for (const plot of this.plots) if (plot !== by) plot.chart.setRange(from, to);
  }
}
