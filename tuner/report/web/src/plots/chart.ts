// A plot on a canvas. It has axes with units, reference lines, bands and a playhead. Dragging zooms, and a
// double click shows all.
import uPlot from "uplot";
import { element, type Child } from "../dom";
import { framedCanvas, savePng, saveButtons, type LegendEntry } from "../export";
import { formatNumber } from "../format";
import { cssColor, onTheme } from "../theme";
import { drawBands, drawLines, type Band, type Line } from "./backdrop";
import { drawMark, type Shape } from "./marks";

export interface ChartSeries {
  label: string;
  colour: () => string;
  values: (number | null | undefined)[];
  width?: number;
  dash?: number[];
  alpha?: number;
  /** If given, marks of this size are drawn instead of a line. */
  marks?: number;
  /** Shape of the marks; if left out, dots. */
  shape?: Shape;
  stepped?: boolean;
  shown?: boolean;
}

export interface ChartOptions {
  title: string;
  /** Name of saved files, without extension. */
  file: string;
  xLabel: string;
  yLabel: string;
  height: number;
  x: number[];
  series: ChartSeries[];
  /** Lines at a value of y or x, such as a limit. The axis range includes them. */
  lines?: Line[] | (() => Line[]);
  bands?: () => Band[];
  yLog?: boolean;
  /** Values that the y axis always shows. */
  include?: number[];
  xPad?: number;
  /** Range of the whole x axis; if left out, the range of the data. */
  xRange?: [number, number];
  legend: () => LegendEntry[];
}

export class Chart {
  readonly root: HTMLElement;
  readonly plot: uPlot;
  private readonly line = element("div", { class: "playhead", "aria-hidden": true });
  private playhead: number | null = null;
  /** Called with every new range of x. */
  onZoom: ((from: number, to: number) => void) | null = null;
  /** Called after every drawing, to move elements that lie over the canvas. */
  onDraw: (() => void) | null = null;

  constructor(
    private readonly options: ChartOptions,
    ...below: Child[]
  ) {
    const place = element("div", { class: "canvas" });
    const save = () => savePng(framedCanvas(this.plot.ctx.canvas, options.title, options.legend()), options.file);
    this.root = element(
      "figure",
      { class: "plot", tabindex: 0, "aria-label": `${options.title}: plot` },
      element(
        "figcaption",
        {},
        element("span", { class: "plot-title" }, options.title),
        saveButtons(options.title, [{ label: "PNG", save }]),
      ),
      place,
      ...below,
    );
    this.plot = new uPlot(this.uplotOptions(), this.data(), place);
    this.plot.over.append(this.line);
    new ResizeObserver(() => {
      const width = Math.floor(place.clientWidth);
      if (width > 0 && width !== this.plot.width) this.plot.setSize({ width, height: options.height });
    }).observe(place);
    onTheme(() => this.plot.redraw(false));
    this.root.addEventListener("keydown", (event) => this.zoomByKey(event));
  }

  show(series: number, shown: boolean): void {
    this.plot.setSeries(series + 1, { show: shown });
  }

  isShown(series: number): boolean {
    return this.plot.series[series + 1]?.show !== false;
  }

  redraw(): void {
    this.plot.redraw(false);
  }

  range(): [number, number] {
    const scale = this.plot.scales["x"];
    return [scale?.min ?? 0, scale?.max ?? 1];
  }

  setRange(from: number, to: number): void {
    const [min, max] = this.range();
    if (Math.abs(min - from) + Math.abs(max - to) > 1e-9 * (1 + Math.abs(to))) {
      this.plot.setScale("x", { min: from, max: to });
    }
  }

  fullRange(): [number, number] {
    if (this.options.xRange !== undefined) return this.options.xRange;
    const { x } = this.options;
    const pad = this.options.xPad ?? 0;
    const lines = this.linesOf("x").map((line) => line.value);
    return [Math.min(x[0] ?? 0, ...lines) - pad, Math.max(x[x.length - 1] ?? 1, ...lines) + pad];
  }

  /** Zooms around the playhead if it is visible, otherwise around the middle. */
  zoomBy(factor: number): void {
    const [min, max] = this.range();
    const [low, high] = this.fullRange();
    const middle = this.playhead !== null && this.playhead >= min && this.playhead <= max ? this.playhead : (min + max) / 2;
    this.setRange(Math.max(low, middle - (middle - min) * factor), Math.min(high, middle + (max - middle) * factor));
  }

  showAll(): void {
    this.setRange(...this.fullRange());
  }

  setPlayhead(x: number): void {
    this.playhead = x;
    this.placeLine();
  }

  private zoomed(): void {
    const [from, to] = this.range();
    this.root.dataset["from"] = formatNumber(from);
    this.root.dataset["to"] = formatNumber(to);
    this.onZoom?.(from, to);
  }

  private placeLine(): void {
    const [min, max] = this.range();
    const shown = this.playhead !== null && this.playhead >= min && this.playhead <= max;
    this.line.hidden = !shown;
    if (shown) this.line.style.transform = `translateX(${this.plot.valToPos(this.playhead ?? 0, "x").toFixed(1)}px)`;
  }

  private zoomByKey(event: KeyboardEvent): void {
    if (event.target !== this.root || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "+" || event.key === "=") this.zoomBy(0.5);
    else if (event.key === "-") this.zoomBy(2);
    else if (event.key === "0" || event.key === "Escape") this.showAll();
    else return;
    event.preventDefault();
  }

  private data(): uPlot.AlignedData {
    return [this.options.x, ...this.options.series.map((one) => one.values)] as uPlot.AlignedData;
  }

  private uplotOptions(): uPlot.Options {
    const { options } = this;
    const font = "12px system-ui, sans-serif";
    const axis = (label: string, more: Partial<uPlot.Axis>): uPlot.Axis => ({
      label,
      labelFont: font,
      font,
      labelSize: 18,
      stroke: () => cssColor("ink-2"),
      grid: { stroke: () => cssColor("grid"), width: 1 },
      ticks: { stroke: () => cssColor("grid"), width: 1, size: 4 },
      ...more,
    });
    const fullRange = () => this.fullRange();
    const series = options.series.map((one): uPlot.Series => {
      const marks = one.marks;
      const made: uPlot.Series = {
        label: one.label,
        stroke: one.colour,
        width: one.width ?? 1.25,
        alpha: one.alpha ?? 1,
        show: one.shown ?? true,
        points: { show: false },
      };
      if (one.dash !== undefined) made.dash = one.dash;
      if (marks !== undefined) made.paths = () => null;
      else if (one.stepped === true && uPlot.paths.stepped) made.paths = uPlot.paths.stepped({ align: 1 });
      return made;
    });
    return {
      width: 300,
      height: options.height,
      legend: { show: false },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: false, dist: 6 } },
      scales: {
        x: { time: false, range: (_u, min, max) => (min === null ? fullRange() : this.padded(min, max)) },
        y: { distr: options.yLog === true ? 3 : 1, range: (_u, min, max) => this.yRange(min, max) },
      },
      axes: [
        axis(options.xLabel, { size: 30, space: 60, values: (_u, ticks) => ticks.map((tick) => formatNumber(tick)) }),
        axis(options.yLabel, {
          size: 52,
          space: 26,
          values: (_u, ticks) => ticks.map((tick) => (tick === null ? null : formatNumber(tick)) as string),
        }),
      ],
      series: [{}, ...series],
      hooks: {
        drawClear: [(u) => drawBands(u, options.bands?.() ?? [])],
        drawSeries: [(u, index) => this.drawMarks(u, index)],
        draw: [(u) => drawLines(u, this.linesOf("x"), this.linesOf("y")), () => this.placeLine(), () => this.onDraw?.()],
        setScale: [
          (_u, key) => {
            if (key === "x") this.zoomed();
          },
        ],
      },
      padding: [8, 12, 0, 0],
    };
  }

  /** Returns the range of x to show. The full range of the data gets its margin; a narrower range is a zoom
   * and is kept. */
  private padded(min: number, max: number): [number, number] {
    const x = this.options.x;
    const [low, high] = this.fullRange();
    if (min <= (x[0] ?? 0) && max >= (x[x.length - 1] ?? 1)) return [low, high === low ? low + 1 : high];
    return [Math.max(min, low), Math.min(max, high)];
  }

  private yRange(min: number | null, max: number | null): [number, number] {
    let low = min ?? 0;
    let high = max ?? 1;
    for (const value of [...(this.options.include ?? []), ...this.linesOf("y").map((line) => line.value)]) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    if (this.options.yLog === true) return [low / 1.3, high * 1.3];
    const room = high > low ? 0.06 * (high - low) : Math.max(Math.abs(high) * 0.1, 1e-9);
    return [low === 0 ? 0 : low - room, high === 0 && low < 0 ? 0 : high + room];
  }

  private linesOf(axis: "x" | "y"): Line[] {
    const lines = this.options.lines ?? [];
    return (typeof lines === "function" ? lines() : lines).filter((line) => (line.axis ?? "y") === axis);
  }

  private drawMarks(u: uPlot, index: number): void {
    const one = this.options.series[index - 1];
    if (one?.marks === undefined) return;
    const { ctx, bbox } = u;
    const size = one.marks * devicePixelRatio;
    const colour = one.colour();
    const [from, to] = this.range();
    ctx.save();
    ctx.beginPath();
    // The margin shows a mark on the edge completely.
    ctx.rect(bbox.left - size, bbox.top - size, bbox.width + 2 * size, bbox.height + 2 * size);
    ctx.clip();
    one.values.forEach((value, i) => {
      const x = this.options.x[i] ?? NaN;
      if (value === null || value === undefined || !(x >= from && x <= to)) return;
      drawMark(ctx, one.shape ?? "dot", u.valToPos(x, "x", true), u.valToPos(value, "y", true), size, colour);
    });
    ctx.restore();
  }
}
