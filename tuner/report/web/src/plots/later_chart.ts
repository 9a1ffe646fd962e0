// Charts of lines that are made when their place on the page is near the visible part.
import { element } from "../dom";
import { whenVisible } from "../lazy";
import { Chart, type ChartSeries } from "./chart";
import { legendEntries, legendOf } from "./legend";

/** Puts a chart on the page as soon as its place is near the visible part. All charts of a list zoom together. */
export function later(make: () => Chart, together: Chart[]): HTMLElement {
  const place = element("div", { class: "plot-place" });
  whenVisible(place, () => {
    const chart = make();
    place.replaceWith(chart.root);
    const [other] = together;
    if (other !== undefined) chart.setRange(...other.range());
    chart.onZoom = (from, to) => together.forEach((one) => one !== chart && one.setRange(from, to));
    together.push(chart);
  });
  return place;
}

export function chartOf(title: string, file: string, xLabel: string, yLabel: string, x: number[], series: ChartSeries[], include: number[]): Chart {
  const chart: Chart = new Chart(
    { title, file, xLabel, yLabel, height: 200, x, series, include, legend: () => legendEntries(series) },
    legendOf(series, (i, shown) => chart.show(i, shown)),
  );
  return chart;
}
