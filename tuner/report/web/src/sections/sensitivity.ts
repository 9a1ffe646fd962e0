// The section that shows which gains matter.
import type { ReportData } from "../data";
import { element, svg } from "../dom";
import { formatNumber } from "../format";
import { drawing, fitted, label } from "../plots/drawing";
import { ticks } from "../plots/ticks";
import { section, type Section } from "./section";

export function sensitivitySection(data: ReportData): Section | null {
  const gains = [...(data.sensitivity ?? [])].sort(
    (a, b) => (b.importance ?? -1) - (a.importance ?? -1) || (b.local ?? -1) - (a.local ?? -1),
  );
  if (gains.length === 0) return null;
  const largest = Math.max(...gains.flatMap((gain) => [gain.importance ?? 0, gain.local ?? 0]), 1e-12);
  const picture = drawing({
    title: "Change of the merit [1]",
    file: "sensitivity",
    draw: (into, width) => {
      const narrow = width < 640;
      const left = narrow ? 0 : Math.min(320, 0.36 * width);
      const right = width - 64;
      const height = narrow ? 42 : 26;
      const at = (value: number) => left + (Math.max(value, 0) / largest) * (right - left);
      const bottom = gains.length * height + 4;
      for (const tick of ticks(0, largest, narrow ? 3 : 6)) {
        into.append(
          svg("line", { x1: at(tick), x2: at(tick), y1: 0, y2: bottom, class: "gridline" }),
          label(at(tick), bottom + 16, formatNumber(tick), tick === 0 ? "start" : "middle", "faint"),
        );
      }
      gains.forEach((gain, i) => {
        const y = i * height;
        const top = narrow ? y + 21 : y + 6;
        const importance = gain.importance ?? 0;
        into.append(
          label(0, y + 17, fitted(gain.gain, narrow ? width - 10 : left - 12)),
          svg("rect", { x: left, y: top, width: Math.max(at(importance) - left, 1), height: 9, class: "bar-main" }),
          svg("rect", { x: left, y: top + 10, width: Math.max(at(gain.local ?? 0) - left, 1), height: 4, class: "bar-side" }),
          label(at(Math.max(importance, gain.local ?? 0)) + 6, top + 10, formatNumber(gain.importance, 3), "start", "faint"),
        );
      });
      return bottom + 24;
    },
  });
  const body = element("tbody");
  for (const gain of gains) {
    const cells = [gain.importance, gain.local, gain.elasticity, gain.rank_correlation];
    body.append(
      element(
        "tr",
        {},
        element("th", { scope: "row" }, gain.gain),
        ...cells.map((value) => element("td", { class: "number" }, formatNumber(value, 3))),
      ),
    );
  }
  const names = ["gain", "importance", "local", "elasticity", "rank correlation"];
  const head = element("tr");
  names.forEach((name, i) => head.append(element("th", { scope: "col", class: i > 0 && "number" }, name)));
  return section(
    "sensitivity",
    "Sensitivity",
    "Which gains matter",
    element(
      "ul",
      { class: "key" },
      element("li", {}, element("span", { class: "mark bar-main" }), "importance: increase of the merit (objective and violations) if this gain alone returns to its start value"),
      element("li", {}, element("span", { class: "mark bar-side" }), "local: largest relative change of the merit for a small step of the gain"),
    ),
    picture,
    element(
      "details",
      {},
      element("summary", {}, "All numbers"),
      element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Sensitivity" }, element("table", {}, element("thead", {}, head), body)),
    ),
  );
}
