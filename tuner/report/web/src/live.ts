// While the run goes on: how far it is, and the page loads itself again. A browser keeps the place it is scrolled to.
import type { Live } from "./data";
import { element } from "./dom";
import { duration } from "./format";

export function liveLine(live: Live): HTMLElement {
  const share = Math.min(1, live.evaluations / Math.max(1, live.most_evaluations));
  const left = live.seconds_left === null ? "" : `, about ${duration(live.seconds_left)} left`;
  return element(
    "div",
    { id: "live", class: "live", role: "status" },
    element("progress", { max: 1, value: share, "aria-label": "Evaluations" }),
    element("p", {}, `${live.evaluations} of ${live.most_evaluations} evaluations${left}. Written at ${live.written}, loaded again every ${live.every} s; in the analysis after the search, and when the run has ended, that time stands still.`),
  );
}

export function reloadLater(live: Live): void {
  setTimeout(() => location.reload(), 1000 * live.every);
}
