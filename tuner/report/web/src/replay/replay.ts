// The 3D replay of a scenario, with its controls.
import type { ReportData, Robot, Run, Scenario } from "../data";
import { element, toggle } from "../dom";
import { savePng, saveButtons } from "../export";
import { fileName, formatTime, formatValue } from "../format";
import { watchVisible } from "../lazy";
import { rampGradient } from "../palette";
import { SPEEDS, type Playhead } from "../playhead";
import { endOf, isOver } from "../runs";
import { Meters } from "./meters";
import { Recording } from "./recording";
import { Stage } from "./stage";
import { stateAt, stateStrip } from "./state_strip";
import { hasWebGl } from "./viewer";

function undrawnWords(undrawn: number): string {
  const these = undrawn === 1 ? "1 shape of the arm is" : `${undrawn} shapes of the arm are`;
  return `${these} not drawn: meshes that were not found, are not STL or OBJ, or are too large.`;
}

export class Replay {
  readonly root: HTMLElement;
  private stage: Stage | null = null;
  private readonly place = element("div", { class: "stage" });
  /** Position error with the last colour of the trail [m], the same for all runs; 0 if no run tracks a
   * position. */
  private readonly errorScale: number;
  private readonly strip = element("div", { class: "strip-place" });
  private readonly state = element("span", { class: "state", role: "status", "aria-live": "off" });
  private readonly over = element("div", { class: "over-now", role: "status", "aria-live": "off" });
  private readonly meters: Meters;
  private ghostShown = true;
  private trailLength = 10;
  private alive = false;
  private visible = true;
  private recording: Recording | null = null;

  constructor(
    private readonly data: ReportData,
    private readonly robot: Robot,
    private readonly scenario: Scenario,
    private readonly playhead: Playhead,
    private run: Run,
  ) {
    this.meters = new Meters(robot);
    this.errorScale = Math.max(...scenario.runs.map((one) => new Recording(one).errorScale()), 0);
    this.root = element(
      "div",
      { class: "replay" },
      element("div", { class: "stage-frame" }, this.place, this.state, this.over),
      this.controls(),
      robot.undrawn > 0 && element("p", { class: "note undrawn" }, undrawnWords(robot.undrawn)),
      element("div", { class: "below" }, this.meters.root, this.key()),
    );
    new ResizeObserver(() => this.resize()).observe(this.place);
    watchVisible(this.place, (visible) => {
      this.visible = visible;
      this.follow(this.playhead.time);
    });
    playhead.onTime((time) => this.follow(time));
    this.setRun(run);
  }

  /** Makes the scene, or frees its memory. */
  setAlive(alive: boolean): void {
    if (alive === this.alive) return;
    this.alive = alive;
    this.rebuild();
  }

  setRun(run: Run): void {
    if (run === this.run && this.recording !== null) return;
    this.run = run;
    this.recording = new Recording(run);
    this.strip.replaceChildren(stateStrip(run, this.scenario, this.playhead.duration));
    this.rebuild();
    this.follow(this.playhead.time);
  }

  setTheme(): void {
    this.stage?.setTheme();
  }

  /** Returns the run of the first gain set, or null if it is the shown run or has no replay. */
  private reference(): Run | null {
    const first = this.scenario.runs.find((run) => run.set === 0);
    return first === undefined || first === this.run || first.replay.n === 0 ? null : first;
  }

  private rebuild(): void {
    this.stage?.viewer.dispose();
    this.stage = null;
    this.place.replaceChildren();
    if (!this.alive) return;
    if (!hasWebGl()) {
      this.say("No 3D replay: this browser has no WebGL. The plots and tables show the same run.");
      return;
    }
    try {
      this.stage = new Stage(this.robot, this.scenario, this.run, this.reference(), this.errorScale);
    } catch (error) {
      this.say(`No 3D replay: ${error instanceof Error ? error.message : String(error)}`);
      return;
    }
    const { canvas } = this.stage.viewer;
    canvas.setAttribute("role", "img");
    canvas.setAttribute(
      "aria-label",
      `3D replay of ${this.scenario.name}. Space plays, arrows move the time, Shift with arrows turns the view, plus and minus zoom, 0 resets it.`,
    );
    this.stage.trailLength = this.trailLength;
    this.stage.showGhost(this.ghostShown);
    this.place.append(canvas);
    this.resize();
    this.stage.show(this.playhead.time);
  }

  private say(words: string): void {
    this.place.replaceChildren(element("p", { class: "no-webgl" }, words));
  }

  private resize(): void {
    this.stage?.viewer.resize(this.place.clientWidth, this.place.clientHeight);
  }

  private follow(time: number): void {
    if (this.visible) this.stage?.show(time);
    if (this.recording !== null) this.meters.show(this.recording.ratiosAt(time));
    this.state.textContent = stateAt(this.run, this.scenario, time);
    const reference = this.ghostShown ? this.reference() : null;
    const over = [this.run, reference].filter((run): run is Run => run !== null && isOver(run, time));
    this.over.replaceChildren(...over.map((run) => element("p", {}, endOf(run, this.data.sets[run.set] ?? ""))));
  }

  private toPeak(): void {
    this.playhead.pause();
    this.playhead.seek(this.recording?.peakTime() ?? 0);
  }

  private controls(): HTMLElement {
    const { playhead } = this;
    const play = element("button", { type: "button", class: "play", onclick: () => playhead.toggle() });
    playhead.onPlaying((playing) => {
      play.textContent = playing ? "Pause" : "Play";
      play.classList.toggle("on", playing);
    });
    const slider = element("input", {
      type: "range",
      class: "scrub",
      min: 0,
      max: playhead.duration,
      step: "any",
      "aria-label": "Time",
    });
    slider.addEventListener("input", () => playhead.seek(Number(slider.value)));
    const clock = element("output", { class: "clock" });
    playhead.onTime((time) => {
      slider.value = String(time);
      slider.setAttribute("aria-valuetext", formatTime(time, playhead.duration));
      clock.textContent = formatTime(time, playhead.duration);
    });
    const speed = element("select", { "aria-label": "Speed" });
    for (const rate of SPEEDS) {
      speed.append(element("option", { value: rate, selected: rate === playhead.speed }, `× ${rate}`));
    }
    speed.addEventListener("change", () => (playhead.speed = Number(speed.value)));
    const trail = element("select", { "aria-label": "Length of the tool's trail" });
    for (const [length, label] of [[2, "trail 2 s"], [10, "trail 10 s"], [1e9, "whole trail"]] as const) {
      trail.append(element("option", { value: length, selected: length === 10 }, label));
    }
    trail.addEventListener("change", () => {
      this.trailLength = Number(trail.value);
      if (this.stage !== null) this.stage.trailLength = this.trailLength;
      this.stage?.show(playhead.time);
    });
    const ghost =
      this.hasGhost() &&
      toggle(`Ghost: ${this.data.sets[0] ?? ""}`, true, (shown) => {
        this.ghostShown = shown;
        this.stage?.showGhost(shown);
        this.follow(playhead.time);
      });
    const peak = element(
      "button",
      { type: "button", title: "Go to the time when a joint is closest to its velocity limit", onclick: () => this.toPeak() },
      "Closest to limit",
    );
    const view = element("button", { type: "button", onclick: () => this.stage?.viewer.reset() }, "Reset view");
    const save = () => {
      if (this.stage === null) return;
      savePng(this.stage.viewer.picture(), fileName(this.scenario.name, "replay", playhead.time.toFixed(2)));
    };
    return element(
      "div",
      { class: "controls" },
      element("div", { class: "row" }, play, element("div", { class: "track" }, this.strip, slider), clock),
      element(
        "div",
        { class: "row small" },
        speed,
        trail,
        ghost,
        peak,
        view,
        saveButtons("3D replay", [{ label: "PNG", save }]),
      ),
    );
  }

  private obstacleWords(): string {
    if (this.data.plan === undefined) return "obstacle and its zone of influence";
    return this.scenario.influence_radius > 0 ? "obstacle and the clearance that the plan keeps" : "obstacle that the plan ignores";
  }

  /** True if there is a reference run and another run, both with a replay. */
  private hasGhost(): boolean {
    const replayed = this.scenario.runs.filter((run) => run.replay.n > 0);
    return replayed.length > 1 && replayed.some((run) => run.set === 0);
  }

  /** Returns the key to the picture, with the items that occur in a run of the scenario. */
  private key(): HTMLElement {
    const { scenario } = this;
    const replays = scenario.runs.map((run) => run.replay).filter((replay) => replay.n > 0);
    const ramp = element("span", { class: "ramp", "aria-hidden": true });
    ramp.style.background = rampGradient();
    const item = (kind: string, text: string) =>
      element("li", {}, element("span", { class: `mark ${kind}`, "aria-hidden": true }), text);
    return element(
      "ul",
      { class: "key", "aria-label": "Key to the 3D replay" },
      this.errorScale > 0 && element("li", { class: "wide" }, "position error 0 ", ramp, ` ${formatValue(this.errorScale * 1000, "mm")}`),
      scenario.path.length > 0 && item("path", "desired path"),
      replays.some((replay) => replay.target.length > 0) && item("target", "target and line of sight"),
      replays.some((replay) => replay.target.length > 0) && item("gaze", "tool’s z axis"),
      this.hasGhost() && item("ghost", `${this.data.sets[0] ?? ""} (ghost)`),
      replays.some((replay) => replay.obstacles.length > 0) && item("obstacle", this.obstacleWords()),
      scenario.cell.length > 0 && item("cell", "part of the cell"),
      replays.some((replay) => replay.closest.length > 0) && item("closest", "closest points of the arm and of what it must not touch"),
      item("hot", "joint above 80 % of its velocity limit"),
    );
  }
}
