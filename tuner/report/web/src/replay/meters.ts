// Bars beside the picture that show how close every joint is to its velocity limit.
import type { Robot } from "../data";
import { element } from "../dom";
import { formatPercent } from "../format";
import { WARN_FROM } from "./arm";

export class Meters {
  readonly root = element("ul", { class: "meters", "aria-label": "Joint velocities divided by their limits" });
  private readonly rows: { bar: HTMLElement; text: HTMLElement }[];

  constructor(robot: Robot) {
    this.rows = robot.joints.map((joint) => {
      const bar = element("span", { class: "fill" });
      const text = element("span", { class: "figure" });
      this.root.append(
        element("li", {}, element("span", { class: "name" }, joint.name), element("span", { class: "bar" }, bar), text),
      );
      return { bar, text };
    });
  }

  show(ratios: number[]): void {
    this.rows.forEach(({ bar, text }, i) => {
      const ratio = ratios[i] ?? NaN;
      bar.style.width = `${Math.min(Math.max(ratio || 0, 0), 1) * 100}%`;
      bar.classList.toggle("near", ratio >= WARN_FROM && ratio < 1);
      bar.classList.toggle("over", ratio >= 1);
      text.textContent = Number.isNaN(ratio) ? "–" : formatPercent(ratio, 0);
    });
  }
}
