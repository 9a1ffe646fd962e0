// Colours that colour-blind readers can tell apart: the eight of Okabe and Ito (2008). On a dark page, white
// replaces black.
import { isDark } from "./theme";

export const BLUE = "#0072B2";
export const VERMILLION = "#D55E00";
export const GREEN = "#009E73";
export const ORANGE = "#E69F00";
export const PURPLE = "#CC79A7";
export const SKY = "#56B4E9";
export const YELLOW = "#F0E442";

/** Brighter colours of the same hue, for a dark page. */
const ON_DARK: Record<string, string> = { [BLUE]: "#3d9fd9", [GREEN]: "#1fbf92", [VERMILLION]: "#f07a2b" };

export function onPage(colour: string): string {
  return isDark() ? (ON_DARK[colour] ?? colour) : colour;
}

const SERIES = [BLUE, VERMILLION, GREEN, ORANGE, PURPLE, SKY];

/** Returns the colour of the i-th series of a plot. After six the colours repeat; the legend tells them
 * apart. */
export function seriesColour(i: number): string {
  return onPage(SERIES[i % SERIES.length] ?? BLUE);
}

/** Returns the colour of an axis: 0, 1, 2 for x, y, z. */
export function axisColour(axis: number): string {
  return onPage([VERMILLION, GREEN, BLUE][axis] ?? BLUE);
}

export function withAlpha(hex: string, alpha: number): string {
  return `${hex}${Math.round(255 * alpha)
    .toString(16)
    .padStart(2, "0")}`;
}

/** Returns the colour of the band for a controller state; null for following the path, which has no band. */
export function stateColour(name: string): string | null {
  switch (name) {
    case "followTrajectory":
      return null;
    case "leaveSingularity":
      return "#888888";
    case "returnToTrajectory":
      return SKY;
    case "avoidObstacles":
      return VERMILLION;
    default:
      return PURPLE;
  }
}

export const SLERP_COLOUR = YELLOW;

/** Colours for errors from 0 to 1 along the tool's path: dark blue, teal, yellow, with even steps in
 * lightness. */
const RAMP: [number, number, number][] = [
  [0.15, 0.26, 0.62],
  [0.0, 0.5, 0.66],
  [0.25, 0.69, 0.49],
  [0.78, 0.8, 0.25],
  [0.99, 0.72, 0.12],
];

export function rampColour(x: number): [number, number, number] {
  const place = Math.min(Math.max(Number.isNaN(x) ? 0 : x, 0), 1) * (RAMP.length - 1);
  const i = Math.min(Math.floor(place), RAMP.length - 2);
  const a = RAMP[i] ?? [0, 0, 0];
  const b = RAMP[i + 1] ?? a;
  const part = place - i;
  return [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])];
}

export function rampGradient(): string {
  const stops = RAMP.map((c) => `rgb(${c.map((v) => Math.round(255 * v)).join(" ")})`);
  return `linear-gradient(90deg, ${stops.join(", ")})`;
}
