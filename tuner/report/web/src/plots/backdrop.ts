// Behind and across what is plotted: bands of x, dashed lines at limits.
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

/** Those at values of x, and of y. */
export function drawLines(u: uPlot, ofX: Line[], ofY: Line[]): void {
  const { ctx, bbox } = u;
  const scale = devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = cssColor("limit");
  ctx.lineWidth = scale;
  ctx.setLineDash([6 * scale, 4 * scale]);
  ctx.font = `${11 * scale}px system-ui, sans-serif`;
  const [right, bottom] = [bbox.left + bbox.width, bbox.top + bbox.height];
  const stroke = (x0: number, y0: number, x1: number, y1: number) => {
    ctx.beginPath();
    ctx.moveTo(x0, y0);
    ctx.lineTo(x1, y1);
    ctx.stroke();
  };
  for (const { value, label } of ofY) {
    const y = u.valToPos(value, "y", true);
    if (y < bbox.top || y > bottom) continue;
    stroke(bbox.left, y, right, y);
    ctx.textAlign = "right";
    ctx.textBaseline = y - bbox.top > 18 * scale ? "bottom" : "top";
    ctx.fillText(label, right - 4 * scale, y + (ctx.textBaseline === "top" ? 3 : -2) * scale);
  }
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
