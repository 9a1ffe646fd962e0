// A strip above the slider that shows the states of the controller over the whole run.
import type { Run, Scenario } from "../data";
import { element } from "../dom";
import { isOver } from "../runs";
import { SLERP_COLOUR, stateColour } from "../palette";

/** Returns the state of the controller at a time; empty once the run is over. */
export function stateAt(run: Run, scenario: Scenario, time: number): string {
  if (isOver(run, time)) return "";
  let state = -1;
  for (const change of run.states) if (change.t <= time) state = change.state;
  const slerping = run.slerps.some(([from, to]) => time >= from && time < to);
  return [scenario.states[state] ?? "", slerping ? "slerp" : ""].filter((part) => part !== "").join(" · ");
}

/** Returns the strip. `duration`: length of the slider below it [s]. */
export function stateStrip(run: Run, scenario: Scenario, duration: number): HTMLElement {
  const strip = element("div", { class: "strip", "aria-hidden": true });
  const add = (from: number, to: number, colour: string, kind: string) => {
    const part = element("span", { class: kind });
    part.style.left = `${(100 * from) / duration}%`;
    part.style.width = `${(100 * Math.max(to - from, 0)) / duration}%`;
    if (colour !== "") part.style.background = colour;
    strip.append(part);
  };
  run.states.forEach((change, i) => {
    const colour = stateColour(scenario.states[change.state] ?? "");
    if (colour !== null) add(change.t, run.states[i + 1]?.t ?? run.end, colour, "state");
  });
  for (const [from, to] of run.slerps) add(from, Math.min(to, run.end), SLERP_COLOUR, "slerp");
  if (run.end < duration) add(run.end, duration, "", "over");
  return strip;
}
