// Lets the reader select a mark of a plot by pointing, by a tap, or by arrow keys while the plot has the
// focus.
import { element } from "../dom";
import type { Chart } from "./chart";

export interface Mark {
  x: number;
  y: number;
  /** Index of its series. Marks of hidden series cannot be selected. */
  series: number;
  text: string;
}

const NEAR = 30;  // px, largest distance of the pointer

/** Returns the index of the next visible mark after (or before) the current one. At the ends it is the
 * current one; -1 if there is none. */
export function stepFrom(shown: boolean[], current: number, step: 1 | -1): number {
  const n = shown.length;
  const begin = current < 0 ? (step > 0 ? -1 : n) : current;
  for (let i = begin + step; i >= 0 && i < n; i += step) if (shown[i] === true) return i;
  return shown[current] === true ? current : -1;
}

/** Makes the marks of a chart selectable. `marks`: in the order of x; `told`: gets the text of the selected
 * mark. */
export function readMarks(chart: Chart, marks: Mark[], told: HTMLElement): void {
  const { plot } = chart;
  const ring = element("div", { class: "picked", hidden: true, "aria-hidden": true });
  plot.over.append(ring);
  let current = -1;
  const place = () => {
    const mark = marks[current];
    const [from, to] = chart.range();
    ring.hidden = mark === undefined || mark.x < from || mark.x > to;
    if (mark === undefined) return;
    ring.style.transform = `translate(${plot.valToPos(mark.x, "x").toFixed(1)}px, ${plot.valToPos(mark.y, "y").toFixed(1)}px)`;
  };
  const pick = (index: number) => {
    const mark = marks[index];
    if (mark === undefined) return;
    current = index;
    told.textContent = mark.text;
    place();
  };
  const point = (event: PointerEvent) => {
    const box = plot.over.getBoundingClientRect();
    let nearest = -1;
    let distance = NEAR;
    marks.forEach((mark, i) => {
      if (!chart.isShown(mark.series)) return;
      const dx = plot.valToPos(mark.x, "x") - (event.clientX - box.left);
      const dy = plot.valToPos(mark.y, "y") - (event.clientY - box.top);
      // Of several marks in one place, the last one is drawn on top and selected.
      if (Math.hypot(dx, dy) <= distance) [nearest, distance] = [i, Math.hypot(dx, dy)];
    });
    pick(nearest);
  };
  plot.over.addEventListener("pointermove", point);
  plot.over.addEventListener("pointerdown", point);
  chart.onDraw = place;
  chart.root.addEventListener("keydown", (event) => {
    if (event.target !== chart.root || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    pick(stepFrom(marks.map((mark) => chart.isShown(mark.series)), current, step));
  });
}
