// A legend. A click on an entry shows or hides its series.
import { element, toggle } from "../dom";
import type { LegendEntry } from "../export";
import type { ChartSeries } from "./chart";
import { swatch } from "./swatch";

export function legendOf(series: ChartSeries[], show: (index: number, shown: boolean) => void): HTMLElement {
  const legend = element("div", { class: "legend", role: "group", "aria-label": "Legend" });
  series.forEach((one, i) => {
    if (one.values.every((value) => value === null || value === undefined)) return;
    const button = toggle("", true, (on) => {
      one.shown = on;
      show(i, on);
    });
    button.className = "entry";
    button.append(swatch(one.colour, one.marks === undefined ? "" : `mark-${one.shape ?? "dot"}`), one.label);
    legend.append(button);
  });
  return legend;
}

/** Returns the legend for a saved picture, with the visible series. */
export function legendEntries(series: ChartSeries[]): LegendEntry[] {
  return series
    .filter((one) => one.shown !== false && one.values.some((value) => value !== null && value !== undefined))
    .map((one) => ({ label: one.label, colour: one.colour(), mark: one.marks === undefined ? undefined : (one.shape ?? "dot") }));
}
