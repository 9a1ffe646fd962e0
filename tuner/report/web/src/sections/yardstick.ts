// The section that compares each switch of the target, return to the path, and lap with the best that the
// arm's limits allow.
import type { ReportData, YardstickEvent } from "../data";
import { breakable, element, svg } from "../dom";
import { formatNumber, formatRatio, unbroken } from "../format";
import { drawing, fitted, label } from "../plots/drawing";
import { ticks } from "../plots/ticks";
import { section, type Section } from "./section";

const KINDS: Record<YardstickEvent["event"], { heading: string; file: string }> = {
  switch: { heading: "Time until the gaze is on the next target", file: "yardstick-switches" },
  return: { heading: "Time until the path is followed again", file: "yardstick-returns" },
  lap: { heading: "Gaze error of a lap, RMS", file: "yardstick-laps" },
};

/** Returns mrad for radians, because the values are small. */
function shownUnit(unit: string): { unit: string; factor: number } {
  return unit === "rad" ? { unit: "mrad", factor: 1e3 } : { unit, factor: 1 };
}

/** Returns, for example, "realistic_target_switch, 8 s"; with several gain sets, also the set. */
function nameOf(one: YardstickEvent, sets: string[]): string {
  const set = sets.length > 1 ? ` (${sets[one.set] ?? ""})` : "";
  return `${one.scenario}, ${formatNumber(one.time, 4)} s${set}`;
}

function bars(events: YardstickEvent[], sets: string[]): HTMLElement | null {
  const [first] = events;
  if (first === undefined) return null;
  const { unit, factor } = shownUnit(first.unit);
  const { heading, file } = KINDS[first.event];
  const largest = Math.max(...events.flatMap((one) => [one.reached ?? 0, one.limit ?? 0])) * factor;
  if (!(largest > 0)) return null;
  return drawing({
    title: `${heading} [${unit}]`,
    file,
    draw: (into, width) => {
      const narrow = width < 640;
      const left = narrow ? 0 : Math.min(360, 0.4 * width);
      const right = width - 110;
      const height = narrow ? 44 : 28;
      const at = (value: number) => left + (value / largest) * (right - left);
      const bottom = events.length * height + 4;
      for (const tick of ticks(0, largest, narrow ? 3 : 6)) {
        into.append(
          svg("line", { x1: at(tick), x2: at(tick), y1: 0, y2: bottom, class: "gridline" }),
          label(at(tick), bottom + 16, formatNumber(tick), tick === 0 ? "start" : "middle", "faint"),
        );
      }
      events.forEach((one, i) => {
        const y = i * height;
        const top = narrow ? y + 21 : y + 5;
        const reached = (one.reached ?? 0) * factor;
        const limit = (one.limit ?? 0) * factor;
        const figures = [one.reached, one.limit].map((value) => formatNumber(value === null ? null : value * factor, 3)).join(" / ");
        const bar = (value: number, below: number, kind: string) =>
          svg("rect", { x: left, y: top + below, width: Math.max(at(value) - left, 1), height: 8, class: kind }, svg("title", {}, one.words));
        into.append(label(0, y + 16, fitted(nameOf(one, sets), narrow ? width - 10 : left - 12)));
        // A missing value has no bar, because a short bar would mean a small value.
        if (one.reached !== null) into.append(bar(reached, 0, "bar-main"));
        if (one.limit !== null) into.append(bar(limit, 9, "bar-side"));
        into.append(label(at(Math.max(reached, limit)) + 6, top + 12, figures, "start", "faint"));
      });
      return bottom + 24;
    },
  });
}

function table(events: YardstickEvent[], sets: string[]): HTMLElement {
  const names = ["scenario", ...(sets.length > 1 ? ["gains"] : []), "event", "reached", "limit", "ratio", "in words"];
  const head = element("tr");
  for (const name of names) {
    head.append(element("th", { scope: "col", class: ["reached", "limit", "ratio"].includes(name) && "number" }, name));
  }
  const body = element("tbody");
  for (const one of events) {
    const { unit, factor } = shownUnit(one.unit);
    const figure = (value: number | null) =>
      element("td", { class: "number" }, formatNumber(value === null ? null : factor * value, 3), value !== null && element("span", { class: "unit" }, unit));
    const line = element("tr", {}, element("th", { scope: "row" }, breakable(one.scenario)));
    if (sets.length > 1) line.append(element("td", {}, sets[one.set] ?? ""));
    line.append(
      element("td", {}, `${one.event} at ${formatNumber(one.time, 4)} s`),
      figure(one.reached),
      figure(one.limit),
      element("td", { class: "number" }, one.ratio === null ? "–" : formatRatio(one.ratio)),
      element("td", {}, unbroken(one.words)),
    );
    body.append(line);
  }
  return element(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": "Yardstick" },
    element("table", { class: "yardstick" }, element("thead", {}, head), body),
  );
}

export function yardstickSection(data: ReportData): Section | null {
  const events = data.yardstick ?? [];
  if (events.length === 0) return null;
  const kinds = Object.keys(KINDS) as YardstickEvent["event"][];
  return section(
    "yardstick",
    "Yardstick",
    "How good any controller could be",
    element(
      "p",
      { class: "note" },
      "Each event (target switch, return to the path, or lap) is compared with the best motion that was found from the same state of the arm. This motion is planned with exact knowledge of the arm, the targets and the obstacles. It keeps the arm's limits of position, velocity and torque.",
    ),
    element(
      "ul",
      { class: "key" },
      element("li", {}, element("span", { class: "mark bar-main" }), "reached by the controller"),
      element("li", {}, element("span", { class: "mark bar-side" }), "best within the joint limits"),
    ),
    ...kinds.map((kind) => bars(events.filter((one) => one.event === kind), data.sets)),
    table(events, data.sets),
  );
}
