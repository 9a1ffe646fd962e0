// The 3D replay of a scenario with what steers it.
import type { ReportData, Run, Scenario } from "../data";
import { element, toggle } from "../dom";
import { savePng, saveButtons } from "../export";
import { fileName, formatTime, formatValue } from "../format";
import { watchVisible } from "../lazy";
import { rampGradient } from "../palette";
import type { Playhead } from "../playhead";
import { Meters } from "./meters";
import { Recording } from "./recording";
import { Stage } from "./stage";
import { stateAt, stateStrip } from "./state_strip";
import { hasWebGl } from "./viewer";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8];

export class Replay {
  readonly root: HTMLElement;
  private stage: Stage | null = null;
  private readonly place = element("div", { class: "stage" });
  private readonly scale = element("span", {});
  private readonly strip = element("div", { class: "strip-place" });
  private readonly state = element("span", { class: "state", role: "status", "aria-live": "off" });
  private readonly meters: Meters;
  private ghostShown = true;
  private trailLength = 10;
  private alive = false;
  private visible = true;
  private recording: Recording | null = null;

  constructor(
    private readonly data: ReportData,
    private readonly scenario: Scenario,
    private readonly playhead: Playhead,
    private run: Run,
  ) {
    this.meters = new Meters(data.robot);
    this.root = element(
      "div",
      { class: "replay" },
      element("div", { class: "stage-frame" }, this.place, this.state),
      this.controls(),
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

  /** Makes the scene, or gives its memory back. */
  setAlive(alive: boolean): void {
    this.alive = alive;
    this.rebuild();
  }

  setRun(run: Run): void {
    if (run === this.run && this.recording !== null) return;
    this.run = run;
    this.recording = new Recording(run);
    this.strip.replaceChildren(stateStrip(run, this.scenario));
    this.rebuild();
    this.follow(this.playhead.time);
  }

  setTheme(): void {
    this.stage?.setTheme();
  }

  /** The reference, where another run is shown. */
  private reference(): Run | null {
    const first = this.scenario.runs.find((run) => run.set === 0);
    return first === undefined || first === this.run ? null : first;
  }

  private rebuild(): void {
    this.stage?.viewer.dispose();
    this.stage = null;
    this.place.replaceChildren();
    if (!this.alive) return;
    if (!hasWebGl()) {
      this.say("No 3D here: this browser offers no WebGL. The plots and tables show the same run.");
      return;
    }
    try {
      const scale = Math.max(...this.scenario.runs.map((run) => new Recording(run).errorScale()), 0);
      this.stage = new Stage(this.data.robot, this.scenario, this.run, this.reference(), scale);
      this.scale.textContent = formatValue(scale * 1000, "mm");
    } catch (error) {
      this.say(`No 3D here: ${error instanceof Error ? error.message : String(error)}`);
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
      slider.setAttribute("aria-valuetext", formatTime(time));
      clock.textContent = formatTime(time);
    });
    const speed = element("select", { "aria-label": "Speed" });
    for (const rate of SPEEDS) {
      speed.append(element("option", { value: rate, selected: rate === 1 }, `× ${rate}`));
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
      this.scenario.runs.length > 1 &&
      toggle(`Ghost: ${this.data.sets[0] ?? ""}`, true, (shown) => {
        this.ghostShown = shown;
        this.stage?.showGhost(shown);
      });
    const peak = element(
      "button",
      { type: "button", title: "When a joint was closest to its velocity limit", onclick: () => this.toPeak() },
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

  private key(): HTMLElement {
    const ramp = element("span", { class: "ramp", "aria-hidden": true });
    ramp.style.background = rampGradient();
    const item = (kind: string, text: string) =>
      element("li", {}, element("span", { class: `mark ${kind}`, "aria-hidden": true }), text);
    return element(
      "ul",
      { class: "key", "aria-label": "Key to the 3D replay" },
      element("li", { class: "wide" }, "position error 0 ", ramp, " ", this.scale),
      item("path", "desired path"),
      item("target", "target and line of sight"),
      item("gaze", "tool’s z axis"),
      this.scenario.runs.length > 1 && item("ghost", `${this.data.sets[0] ?? ""} (ghost)`),
      this.scenario.obstacles.length > 0 && item("obstacle", "obstacle and its influence"),
      item("hot", "joint above 80 % of its velocity limit"),
    );
  }
}
