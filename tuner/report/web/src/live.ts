// Shows the progress of a run that has not ended, and reloads the page. Browsers keep the scroll position.
import type { Live } from "./data";
import { element } from "./dom";
import { duration } from "./format";

/** Time without a new page after which the run counts as in its analysis, or as killed [s]. */
const SILENT_S = 120;

/** Returns the progress as a text. `now`: seconds since 1970. */
export function liveWords(live: Live, now: number): string {
  const age = now - live.written;
  const done = `${live.evaluations} of ${live.most_evaluations} evaluations`;
  if (age > Math.max(SILENT_S, 10 * live.every)) {
    return `${done}. No new page for ${duration(age)}: the search has ended and its analysis is running, or the run was killed ("armtune tune --resume" resumes it). This page reloads every ${live.every} s.`;
  }
  const left = live.seconds_left === null ? "" : `, about ${duration(live.seconds_left)} left`;
  const written = new Date(1000 * live.written).toISOString().slice(11, 19);
  return `${done}${left}. Written at ${written} UTC; this page reloads every ${live.every} s. It is not rewritten during the analysis after the search.`;
}

export function liveLine(live: Live): HTMLElement {
  const share = Math.min(1, live.evaluations / Math.max(1, live.most_evaluations));
  return element(
    "div",
    { id: "live", class: "live", role: "status" },
    element("progress", { max: 1, value: share, "aria-label": "Evaluations" }),
    element("p", {}, liveWords(live, Date.now() / 1000)),
  );
}

export function reloadLater(live: Live): void {
  setTimeout(() => location.reload(), 1000 * live.every);
}
