// Chooses units that keep axis labels short, such as millimetres for small errors.

export interface Scaled {
  factor: number;
  unit: string;
}

const SMALL: Record<string, string> = { m: "mm", "m/s": "mm/s", rad: "mrad", "rad/s": "mrad/s" };

/** Returns a unit that is a thousand times smaller if no value reaches a tenth of the given unit. */
export function scaleUnit(unit: string, largest: number): Scaled {
  const small = SMALL[unit];
  if (small === undefined || !(largest > 0) || largest >= 0.1) return { factor: 1, unit };
  return { factor: 1000, unit: small };
}

export function largestSize(columns: ArrayLike<number>[]): number {
  let largest = 0;
  for (const column of columns) {
    for (let i = 0; i < column.length; ++i) {
      const size = Math.abs(column[i] ?? NaN);
      if (size > largest) largest = size;
    }
  }
  return largest;
}
