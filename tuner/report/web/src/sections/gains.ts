// The section with the gains: every gain before and after, on the scale of its bounds.
import type { Gain, ReportData } from "../data";
import { element, svg } from "../dom";
import { formatNumber, withUnit } from "../format";
import { drawing, fitted, label } from "../plots/drawing";
import { boundOf, placeOnScale } from "../plots/place_on_scale";
import { section, type Section } from "./section";


function row(into: SVGSVGElement, gain: Gain, y: number, width: number): void {
  const narrow = width < 640;
  const left = narrow ? 6 : Math.min(320, 0.36 * width);
  const right = narrow ? width - 6 : width - 210;
  const middle = narrow ? y + 30 : y + 14;
  const at = (value: number) => left + placeOnScale(gain, value) * (right - left);
  const first = gain.values[0] ?? NaN;
  const last = gain.values[gain.values.length - 1] ?? NaN;
  const bound = boundOf(gain, last);
  const numbers = first === last ? formatNumber(last) : `${formatNumber(first)} → ${formatNumber(last)}`;
  into.append(
    label(narrow ? 6 : 0, y + 18, fitted(gain.name, narrow ? width - 150 : left - 12)),
    label(width, y + 18, withUnit(numbers, gain.unit), "end", first === last ? "faint" : ""),
    svg("line", { x1: left, x2: right, y1: middle, y2: middle, class: "rail" }),
    svg("line", { x1: left, x2: left, y1: middle - 5, y2: middle + 5, class: "rail" }),
    svg("line", { x1: right, x2: right, y1: middle - 5, y2: middle + 5, class: "rail" }),
  );
  if (Math.abs(at(last) - at(first)) > 1) {
    into.append(svg("line", { x1: at(first), x2: at(last), y1: middle, y2: middle, class: "move" }));
  }
  const bounds = `${formatNumber(gain.lower)} to ${withUnit(formatNumber(gain.upper), gain.unit)}, ${gain.scale}`;
  into.append(
    svg("circle", { cx: at(first), cy: middle, r: 5, class: "before" }),
    svg(
      "circle",
      { cx: at(last), cy: middle, r: 5, class: bound === "" ? "after" : "after bound" },
      svg("title", {}, `${gain.name}: ${bounds}${bound === "" ? "" : `; at its ${bound} bound`}`),
    ),
  );
}

export function gainsSection(data: ReportData): Section | null {
  const gains = data.gains ?? [];
  if (gains.length === 0) return null;
  const picture = drawing({
    title: "Gains between their bounds",
    file: "gains",
    draw: (into, width) => {
      const height = width < 640 ? 44 : 28;
      gains.forEach((gain, i) => row(into, gain, i * height, width));
      return gains.length * height + 6;
    },
  });
  const item = (kind: string, text: string) =>
    element("li", {}, element("span", { class: `dot ${kind}`, "aria-hidden": true }), text);
  const several = data.sets.length > 1;
  return section(
    "gains",
    "Gains",
    several ? "Gains before and after" : "Gains",
    element(
      "ul",
      { class: "key" },
      several && item("before", data.sets[0] ?? "before"),
      item("after", data.sets[data.sets.length - 1] ?? "after"),
      item("bound", "at a bound"),
      element("li", {}, "each line runs from the lower to the upper bound"),
    ),
    picture,
  );
}
