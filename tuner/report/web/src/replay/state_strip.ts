// What the controller was doing over the whole run, as a strip above the slider.
import type { Run, Scenario } from "../data";
import { element } from "../dom";
import { SLERP_COLOUR, stateColour } from "../palette";

export function stateAt(run: Run, scenario: Scenario, time: number): string {
  let state = -1;
  for (const change of run.states) if (change.t <= time) state = change.state;
  const slerping = run.slerps.some(([from, to]) => time >= from && time < to);
  return [scenario.states[state] ?? "", slerping ? "slerp" : ""].filter((part) => part !== "").join(" · ");
}

export function stateStrip(run: Run, scenario: Scenario): HTMLElement {
  const strip = element("div", { class: "strip", "aria-hidden": true });
  const add = (from: number, to: number, colour: string, kind: string) => {
    const part = element("span", { class: kind });
    part.style.left = `${(100 * from) / scenario.duration}%`;
    part.style.width = `${(100 * (to - from)) / scenario.duration}%`;
    part.style.background = colour;
    strip.append(part);
  };
  run.states.forEach((change, i) => {
    const colour = stateColour(scenario.states[change.state] ?? "");
    if (colour !== null) add(change.t, run.states[i + 1]?.t ?? scenario.duration, colour, "state");
  });
  for (const [from, to] of run.slerps) add(from, to, SLERP_COLOUR, "slerp");
  return strip;
}
