// The section about a gain set on many random arms: yield, spread of the metrics, the worst arms.
import type { Histogram, ReportData } from "../data";
import { element, svg } from "../dom";
import { fileName, formatNumber, formatPercent, formatUnit, formatValue } from "../format";
import { drawing, label } from "../plots/drawing";
import { ticks } from "../plots/ticks";
import { section, type Section } from "./section";

function histogram(one: Histogram): HTMLElement {
  const scenario = one.scenario === "" ? "" : `${one.scenario}: `;
  const without = one.failed > 0 ? ` (without ${one.failed} that did not complete)` : "";
  const title = `${scenario}${one.metric}${without}`;
  const values = [...one.edges, ...(one.limit === null ? [] : [one.limit]), ...(one.nominal === null ? [] : [one.nominal])];
  const low = Math.min(...values);
  const high = Math.max(...values);
  const most = Math.max(...one.counts, 1);
  return drawing({
    title,
    file: fileName("robustness", one.scenario, one.metric),
    draw: (into, width) => {
      const [left, right, top, bottom] = [40, width - 14, 34, 160];
      const room = 0.03 * (high - low || 1);
      const x = (value: number) => left + ((value - low + room) / (high - low + 2 * room)) * (right - left);
      const y = (count: number) => bottom - (count / most) * (bottom - top);
      for (const tick of ticks(0, most, 3).filter(Number.isInteger)) {
        into.append(
          svg("line", { x1: left, x2: right, y1: y(tick), y2: y(tick), class: "gridline" }),
          label(left - 6, y(tick) + 4, String(tick), "end", "faint"),
        );
      }
      for (const tick of ticks(low, high, Math.max(2, Math.floor(width / 110)))) {
        into.append(label(x(tick), bottom + 16, formatNumber(tick), "middle", "faint"));
      }
      one.counts.forEach((count, i) => {
        const [from = 0, to = 0] = [one.edges[i], one.edges[i + 1]];
        into.append(
          svg(
            "rect",
            { x: x(from) + 0.5, y: y(count), width: Math.max(x(to) - x(from) - 1, 1), height: bottom - y(count), class: "bar-main" },
            svg("title", {}, `${formatNumber(from)} to ${formatValue(to, one.unit)}: ${count}`),
          ),
        );
      });
      const mark = (value: number | null, text: string, kind: string, row: number) => {
        if (value === null) return;
        const end = x(value) > width * 0.6;
        into.append(
          svg("line", { x1: x(value), x2: x(value), y1: 4 + row * 12, y2: bottom, class: kind }),
          label(x(value) + (end ? -5 : 5), 13 + row * 12, `${text} ${formatNumber(value, 3)}`, end ? "end" : "start", kind),
        );
      };
      mark(one.limit, "limit", "limit", 0);
      mark(one.nominal, "nominal", "nominal", 1);
      into.append(
        svg("line", { x1: left, x2: right, y1: bottom, y2: bottom, class: "rail" }),
        label((left + right) / 2, bottom + 33, one.unit === "1" ? "ratio [1]" : `[${formatUnit(one.unit)}]`, "middle", "faint"),
        label(4, 13, "arms", "start", "faint"),
      );
      return bottom + 40;
    },
  });
}

export function robustnessSection(data: ReportData): Section | null {
  const robustness = data.robustness;
  if (robustness === undefined) return null;
  const [low, high] = robustness.interval;
  const grid = element("div", { class: "histograms" });
  for (const one of robustness.histograms) grid.append(histogram(one));
  const worst = element("ol", { class: "worst" });
  for (const one of robustness.worst) worst.append(element("li", {}, element("b", {}, `arm ${one.sample}`), ` ${one.text}`));
  return section(
    "robustness",
    "Robustness",
    "Robustness",
    element(
      "p",
      { class: "yield" },
      element("b", {}, formatPercent(robustness.yield)),
      ` of ${robustness.samples} random arms keep every limit (95 % interval ${formatPercent(low)} to ${formatPercent(high)})`,
    ),
    grid,
    robustness.worst.length > 0 && element("h3", {}, "Arms that break a limit, the largest joint velocity ratio first"),
    robustness.worst.length > 0 && worst,
  );
}
