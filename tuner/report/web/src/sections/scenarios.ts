// The section with 3D replay and time plots. It shows one scenario at a time. Each has its own playhead.
import type { ReportData, Run, Scenario } from "../data";
import { element, toggle } from "../dom";
import { whenVisible } from "../lazy";
import { SLERP_COLOUR, stateColour } from "../palette";
import { Playhead } from "../playhead";
import { TimePlots } from "../plots/time_plots";
import { Replay } from "../replay/replay";
import { endOf, lastEnd, noReplay, openingTime } from "../runs";
import { onTheme } from "../theme";
import { section, type Section } from "./section";

class Panel {
  readonly root: HTMLElement;
  readonly playhead: Playhead;
  private readonly shown: Set<number>;
  private replay: Replay | null = null;
  private plots: TimePlots | null = null;
  private readonly left = element("div", { class: "left" });
  private open = false;

  constructor(
    private readonly data: ReportData,
    private readonly scenario: Scenario,
    id: string,
    tab: string,
  ) {
    this.root = element("div", { role: "tabpanel", id, "aria-labelledby": tab, class: "panel", hidden: true });
    this.playhead = new Playhead(lastEnd(scenario));
    this.playhead.seek(openingTime(scenario.runs[scenario.runs.length - 1], this.playhead.duration));
    const sets = scenario.runs.map((run) => run.set);
    this.shown = new Set([sets[0] ?? 0, sets[sets.length - 1] ?? 0]);
    onTheme(() => this.replay?.setTheme());
  }

  /** Opens or closes the panel. Its content is made when it is first open and in view. The 3D scene exists
   * only while it is open. */
  setOpen(open: boolean): void {
    this.open = open;
    this.root.hidden = !open;
    if (!open) this.playhead.pause();
    if (this.plots !== null) this.showReplay();
    else if (open) whenVisible(this.root, () => this.build());
  }

  private lastShown(): Run | undefined {
    const shown = this.scenario.runs.filter((run) => this.shown.has(run.set));
    return shown[shown.length - 1] ?? this.scenario.runs[this.scenario.runs.length - 1];
  }

  private build(): void {
    if (this.plots !== null) return;
    this.plots = new TimePlots(
      this.scenario,
      this.data.sets,
      () => this.lastShown(),
      (set) => this.shown.has(set),
      this.playhead,
    );
    this.root.append(
      this.armName() ?? "",
      ...this.troubles(),
      element(
        "div",
        { class: this.canReplay() ? "beside" : "alone" },
        this.left,
        element("div", { class: "right" }, this.key(), this.plots.root),
      ),
    );
    this.showReplay();
  }

  private canReplay(): boolean {
    const hasRobot = this.data.robots[this.scenario.robot] !== undefined;
    return this.scenario.runs.some((run) => noReplay(run, hasRobot, "") === "");
  }

  /** Shows the replay of the last shown run, or the reason why there is none. */
  private showReplay(): void {
    const run = this.lastShown();
    if (run === undefined) return;
    const robot = this.data.robots[this.scenario.robot];
    const words = noReplay(run, robot !== undefined, this.scenario.runs.length > 1 ? (this.data.sets[run.set] ?? "") : "");
    if (words !== "" || robot === undefined) {
      this.replay?.setAlive(false);
      this.left.replaceChildren(element("p", { class: "no-replay" }, words));
      return;
    }
    if (this.replay === null) this.replay = new Replay(this.data, robot, this.scenario, this.playhead, run);
    if (this.replay.root.parentNode !== this.left) this.left.replaceChildren(this.replay.root);
    this.replay.setRun(run);
    this.replay.setAlive(this.open);
  }

  /** Returns the name of the arm, or null if the run has only one arm. */
  private armName(): HTMLElement | null {
    const robot = this.data.robots[this.scenario.robot];
    return this.data.robots.length < 2 || robot === undefined ? null : element("p", { class: "note arm-name" }, `Arm: ${robot.name}`);
  }

  private troubles(): HTMLElement[] {
    return this.scenario.runs
      .filter((run) => run.status !== "completed")
      .map((run) =>
        element("p", { class: "trouble" }, endOf(run, this.data.sets[run.set] ?? "")),
      );
  }

  /** Returns buttons to show and hide gain sets, and the meaning of the bands. */
  private key(): HTMLElement {
    const sets = element("div", { class: "sets", role: "group", "aria-label": "Gain sets in the plots" });
    if (this.scenario.runs.length > 1) {
      for (const run of this.scenario.runs) {
        const result = run.set === Math.max(...this.scenario.runs.map((other) => other.set));
        const button = toggle("", this.shown.has(run.set), (on) => {
          if (on) this.shown.add(run.set);
          else this.shown.delete(run.set);
          this.plots?.refresh();
          this.showReplay();
        });
        button.className = "entry";
        const dash = result ? "line" : run.set === 0 ? "line dashed" : "line dotted";
        button.append(element("span", { class: dash }), this.data.sets[run.set] ?? "");
        sets.append(button);
      }
    }
    const bands = element("ul", { class: "bands", "aria-label": "Bands behind the plots" });
    const band = (colour: string, name: string) => {
      const mark = element("span", { class: "mark", "aria-hidden": true });
      mark.style.background = colour;
      bands.append(element("li", {}, mark, name));
    };
    const zoom = (label: string, words: string, factor: number | null) =>
      element("button", { type: "button", "aria-label": words, onclick: () => this.plots?.zoomBy(factor) }, label);
    const used = new Set(this.scenario.runs.flatMap((run) => run.states.map((change) => change.state)));
    this.scenario.states.forEach((name, i) => {
      const colour = stateColour(name);
      if (colour !== null && used.has(i)) band(colour, name);
    });
    if (this.scenario.runs.some((run) => run.slerps.length > 0)) band(SLERP_COLOUR, "slerp");
    return element(
      "div",
      { class: "plots-key" },
      sets,
      bands,
      element("span", { class: "zoom", role: "group", "aria-label": "Zoom of the time axis" }, zoom("−", "Zoom out", 2), zoom("+", "Zoom in", 0.5), zoom("All", "Show the whole run", null)),
      element("p", { class: "note" }, "Drag to zoom, double-click to show all. The pointer sets the time."),
    );
  }
}

function inWindow(place: Element): boolean {
  const box = place.getBoundingClientRect();
  return box.bottom > 0 && box.top < innerHeight;
}

/** Moves the time by keys, unless the element with the focus uses these keys itself. */
function steerByKeys(current: () => Panel | undefined): void {
  const steps: Record<string, number> = { ArrowLeft: -0.1, ArrowRight: 0.1, PageUp: -1, PageDown: 1 };
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    const panel = current();
    if (panel === undefined || !inWindow(panel.root)) return;
    const { playhead } = panel;
    const target = event.target instanceof Element ? event.target : document.body;
    const slider = target.matches("input.scrub");
    if (event.key === " ") {
      if (target.matches("button, select, summary, a, input:not(.scrub), textarea")) return;
      playhead.toggle();
    } else {
      const inReplay = slider || target.matches(".stage canvas, .plot");
      const step = steps[event.key];
      if (step === undefined || target.matches("select, input:not(.scrub), textarea, [role=tab], .scroll")) return;
      if (event.key.startsWith("Page") && !inReplay) return;
      playhead.pause();
      // The steps are smaller in a short run.
      playhead.seek(playhead.time + step * Math.min(1, playhead.duration / 5));
    }
    event.preventDefault();
  });
}

export function scenariosSection(data: ReportData): Section | null {
  const scenarios = data.scenarios.filter((scenario) => scenario.runs.length > 0);
  if (scenarios.length === 0) return null;
  const tabs = element("div", { role: "tablist", class: "tabs", "aria-label": "Scenario" });
  const panels = scenarios.map((scenario, i) => new Panel(data, scenario, `panel-${i}`, `tab-${i}`));
  let current = 0;
  const buttons = scenarios.map((scenario, i) =>
    element(
      "button",
      { type: "button", role: "tab", id: `tab-${i}`, "aria-controls": `panel-${i}`, onclick: () => open(i) },
      scenario.name,
    ),
  );
  const open = (index: number) => {
    current = index;
    buttons.forEach((button, i) => {
      button.setAttribute("aria-selected", String(i === index));
      button.tabIndex = i === index ? 0 : -1;
    });
    panels.forEach((panel, i) => {
      if (i !== index) panel.setOpen(false);
    });
    panels[index]?.setOpen(true);
  };
  tabs.addEventListener("keydown", (event) => {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    open((current + step + scenarios.length) % scenarios.length);
    buttons[current]?.focus();
  });
  tabs.append(...buttons);
  open(0);
  steerByKeys(() => panels[current]);
  return section(
    "replay",
    "Replay and plots",
    "Replay and time plots",
    tabs,
    ...panels.map((panel) => panel.root),
    element("p", { class: "note keys" }, "Keys: space plays and pauses, ← → move the time. In the picture: Shift and arrows turn the view, + − zoom, 0 resets. In a plot: + − zoom, 0 shows all."),
  );
}
