// A plot over time. It shows the columns of one group, with the curves of all shown gain sets over each
// other.
import type { Column, Run, Scenario } from "../data";
import { decodeSeries } from "../decode";
import { element, toggle } from "../dom";
import type { LegendEntry } from "../export";
import { fileName, formatUnit, shortName } from "../format";
import { watchVisible } from "../lazy";
import { axisColour, seriesColour } from "../palette";
import type { Playhead } from "../playhead";
import { timeLabel } from "../runs";
import { alignRuns } from "./align";
import type { Band } from "./backdrop";
import { Chart, type ChartSeries } from "./chart";
import type { Figure } from "./figures";
import { farWords, limitLines } from "./limit_lines";
import { formatReading, valueAt } from "./reading";
import { largestSize, scaleUnit, type Scaled } from "./scale_unit";
import { swatch } from "./swatch";

interface Trace {
  run: Run;
  column: Column;
  /** Index of the column's name in the list of the plot. */
  name: number;
  /** Times and values of the run, as they are stored. */
  time: Float64Array;
  values: Float64Array;
}

/** Number of steps of a stored series, as in decode.ts. */
const STEPS = 65534;

const DASHES: number[][] = [[5, 4], [2, 3], [8, 3, 2, 3], [1, 2]];

/** Returns the style of a line. The result is solid; the reference is faint and dashed; other sets have other
 * dashes. */
function lineOf(run: Run, result: number): Pick<ChartSeries, "dash" | "alpha" | "width"> {
  if (run.set === result) return { width: 1.5 };
  return { dash: DASHES[run.set % DASHES.length] ?? [5, 4], alpha: run.set === 0 ? 0.6 : 0.8, width: 1.1 };
}

function colourOf(name: string, index: number): string {
  const axis = ["x", "y", "z"].indexOf(shortName(name));
  return axis >= 0 && !name.startsWith("joint/") ? axisColour(axis) : seriesColour(index);
}

export class TimePlot {
  readonly chart: Chart;
  private readonly traces: Trace[] = [];
  private readonly names: string[] = [];
  private readonly scaled: Scaled;
  private readonly hidden = new Set<number>();
  private readonly readings: HTMLElement[] = [];
  private visible = true;
  private readAt = -Infinity;

  constructor(
    private readonly figure: Figure,
    private readonly scenario: Scenario,
    private readonly sets: string[],
    private readonly isShown: (set: number) => boolean,
    private readonly playhead: Playhead,
    bands: () => Band[],
  ) {
    const runs: { time: Float64Array; columns: Float64Array[] }[] = [];
    for (const run of scenario.runs) {
      const columns = run.columns.filter((column) => column.group === figure.group);
      if (columns.length === 0) continue;
      const time = decodeSeries(run.time);
      for (const column of columns) {
        if (!this.names.includes(column.name)) this.names.push(column.name);
        this.traces.push({ run, column, name: this.names.indexOf(column.name), time, values: decodeSeries(column.series) });
      }
      runs.push({ time, columns: this.traces.slice(-columns.length).map((trace) => trace.values) });
    }
    const largest = largestSize(runs.flatMap((run) => run.columns));
    const scaled = (this.scaled = scaleUnit(this.traces[0]?.column.unit ?? "1", largest));
    const limits = (scenario.limits ?? []).filter((limit) => limit.group === figure.group);
    const picture = (of: typeof limits) => limitLines(of, largest, scaled.factor, (column) => colourOf(column, this.names.indexOf(column)));
    const drawn = limits.filter((limit) => this.names.includes(limit.column));
    const unhidden = () => drawn.filter((limit) => !this.hidden.has(this.names.indexOf(limit.column)));
    const aligned = alignRuns(runs, scaled.factor);
    const legend = element("div", { class: "legend", role: "group", "aria-label": `Lines of ${figure.title}` });
    this.names.forEach((name, i) => legend.append(this.entry(name, i)));
    const result = Math.max(...scenario.runs.map((run) => run.set));
    this.chart = new Chart(
      {
        title: figure.title,
        file: fileName(scenario.name, figure.group),
        xLabel: timeLabel(scenario.runs),
        yLabel: `${figure.axis} [${formatUnit(scaled.unit) || "1"}]`,
        height: 190,
        x: aligned.x,
        xRange: [0, playhead.duration],
        series: this.traces.map((trace, i) => ({
          label: `${trace.column.name} (${sets[trace.run.set] ?? ""})`,
          colour: () => colourOf(trace.column.name, trace.name),
          values: aligned.columns[i] ?? [],
          shown: this.shows(trace),
          ...lineOf(trace.run, result),
          ...(trace.column.name.startsWith("desired/") ? { dash: [1, 3], width: 1 } : {}),
        })),
        lines: () => [
          ...figure.lines(scenario).map((line) => ({ ...line, value: line.value * scaled.factor })),
          ...picture(unhidden()).lines,
        ],
        include: figure.fromZero ? [0] : [],
        bands,
        legend: () => this.exportLegend(),
      },
      legend,
      farWords(picture(drawn).far),
    );
    this.followPointer();
    watchVisible(this.chart.root, (visible) => {
      this.visible = visible;
      this.readAt = -Infinity;
      this.follow(this.playhead.time);
    });
    playhead.onTime((time) => this.follow(time));
  }

  /** Updates the plot after a gain set or a column was shown or hidden. */
  refresh(): void {
    this.traces.forEach((trace, i) => this.chart.show(i, this.shows(trace)));
    this.readAt = -Infinity;
    this.follow(this.playhead.time);
  }

  private shows(trace: Trace): boolean {
    return this.isShown(trace.run.set) && !this.hidden.has(trace.name);
  }

  private label(name: string): string {
    const short = shortName(name);
    return name.startsWith("desired/") ? `${short} desired` : short;
  }

  private entry(name: string, i: number): HTMLElement {
    const button = toggle("", true, (on) => {
      if (on) this.hidden.delete(i);
      else this.hidden.add(i);
      this.refresh();
    });
    const patch = swatch(() => colourOf(name, i), name.startsWith("desired/") ? "dotted" : "");
    const reading = element("span", { class: "reading" });
    this.readings.push(reading);
    button.className = "entry";
    button.append(patch, element("span", {}, this.label(name)), reading);
    return button;
  }

  private follow(time: number): void {
    if (!this.visible) return;
    this.chart.setPlayhead(time);
    const now = performance.now();
    // Numbers that change sixty times a second cannot be read.
    if (this.playhead.playing && now - this.readAt < 120) return;
    this.readAt = now;
    const { factor } = this.scaled;
    this.readings.forEach((reading, name) => {
      const parts: string[] = [];
      for (const trace of this.traces) {
        if (trace.name !== name || !this.isShown(trace.run.set)) continue;
        const { lo, hi } = trace.column.series;
        const value = valueAt(trace.time, trace.values, time, trace.run.end);
        parts.push(formatReading(value * factor, ((hi - lo) / STEPS) * factor));
      }
      reading.textContent = parts.join(" → ");
    });
  }

  /** Moves the playhead with the pointer while nothing plays, and with a click or a touch at any time. */
  private followPointer(): void {
    const { over } = this.chart.plot;
    over.style.touchAction = "pan-y";
    const seek = (event: PointerEvent) =>
      this.playhead.seek(this.chart.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
    over.addEventListener("pointermove", (event) => {
      if (event.pointerType === "mouse" ? !this.playhead.playing && event.buttons === 0 : event.buttons > 0) seek(event);
    });
    over.addEventListener("pointerdown", (event) => {
      if (event.button === 0) seek(event);
    });
  }

  private exportLegend(): LegendEntry[] {
    return this.traces
      .filter((trace) => this.shows(trace))
      .map((trace) => ({
        label: `${this.label(trace.column.name)}, ${this.sets[trace.run.set] ?? ""}`,
        colour: colourOf(trace.column.name, trace.name),
        faint: trace.run.set === 0 && this.scenario.runs.length > 1,
      }));
  }

  get title(): string {
    return this.figure.title;
  }
}
