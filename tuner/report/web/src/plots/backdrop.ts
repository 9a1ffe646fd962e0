// Draws bands of x behind the curves of a plot, and lines such as limits across it.
import type uPlot from "uplot";
import { cssColor } from "../theme";

export interface Band {
  from: number;
  to: number;
  colour: string;
}

export interface Line {
  value: number;
  label: string;
  axis?: "x" | "y";
  /** Begin and end on x of a line at a value of y; if they are left out, it goes all across. */
  from?: number;
  to?: number;
  /** If left out, the line has the page's colour of limits. */
  colour?: string;
  /** True: the line is solid and thick instead of dashed. */
  thick?: boolean;
}

export function drawBands(u: uPlot, bands: Band[]): void {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  for (const band of bands) {
    const left = u.valToPos(band.from, "x", true);
    ctx.fillStyle = band.colour;
    ctx.fillRect(left, bbox.top, Math.max(u.valToPos(band.to, "x", true) - left, 1), bbox.height);
  }
  ctx.restore();
}

/** Shortest drawn length of a thick line [px], so that it can be seen. */
const SHORTEST = 3;

/** Draws lines at values of x, and at values of y. */
export function drawLines(u: uPlot, ofX: Line[], ofY: Line[]): void {
  const { ctx, bbox } = u;
  const scale = devicePixelRatio;
  ctx.save();
  const set = (colour: string | undefined, thick: boolean) => {
    ctx.strokeStyle = ctx.fillStyle = colour ?? cssColor("limit");
    ctx.lineWidth = (thick ? 3.5 : 1) * scale;
    ctx.setLineDash(thick ? [] : [6 * scale, 4 * scale]);
  };
  ctx.font = `${11 * scale}px system-ui, sans-serif`;
  const [right, bottom] = [bbox.left + bbox.width, bbox.top + bbox.height];
  const stroke = (x0: number, y0: number, x1: number, y1: number) => {
    ctx.beginPath();
    ctx.moveTo(x0, y0);
    ctx.lineTo(x1, y1);
    ctx.stroke();
  };
  const place = (x: number | undefined, without: number) =>
    x === undefined ? without : Math.min(Math.max(u.valToPos(x, "x", true), bbox.left), right);
  for (const { value, label, from, to, colour, thick } of ofY) {
    const y = u.valToPos(value, "y", true);
    if (y < bbox.top || y > bottom) continue;
    const begin = place(from, bbox.left);
    const end = place(to, right);
    // The line is outside the visible range.
    if (begin === end && from !== to) continue;
    set(colour, thick === true);
    const room = thick === true ? Math.max(0, SHORTEST * scale - (end - begin)) / 2 : 0;
    stroke(begin - room, y, end + room, y);
    if (label === "") continue;
    ctx.textAlign = "right";
    ctx.textBaseline = y - bbox.top > 18 * scale ? "bottom" : "top";
    ctx.fillText(label, end - 4 * scale, y + (ctx.textBaseline === "top" ? 3 : -2) * scale);
  }
  set(undefined, false);
  for (const { value, label } of ofX) {
    const x = u.valToPos(value, "x", true);
    if (x < bbox.left || x > right) continue;
    stroke(x, bbox.top, x, bottom);
    ctx.textAlign = x - bbox.left > 0.5 * bbox.width ? "right" : "left";
    ctx.textBaseline = "top";
    ctx.fillText(label, x + (ctx.textAlign === "right" ? -5 : 5) * scale, bbox.top + 4 * scale);
  }
  ctx.restore();
}
