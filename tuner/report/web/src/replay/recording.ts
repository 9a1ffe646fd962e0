// The decoded replay of one run, with its values at any time.
import type { Run, Vec3 } from "../data";
import { decodeSeries, sampleAt } from "../decode";

export class Recording {
  readonly dt: number;
  readonly n: number;
  /** End of the run [s]; afterwards the last sample is held. */
  readonly end: number;
  readonly tool: Float64Array[];
  readonly error: Float64Array;
  private readonly positions: Float64Array[];
  private readonly target: Float64Array[];
  private readonly obstacles: Float64Array[][];
  private readonly cell: Float64Array[][];
  private readonly closest: Float64Array[];
  private readonly ratios: Float64Array[];

  constructor(readonly run: Run) {
    const { replay } = run;
    this.dt = replay.dt;
    this.n = replay.n;
    this.end = run.end;
    this.positions = replay.q.map(decodeSeries);
    this.target = replay.target.map(decodeSeries);
    this.obstacles = replay.obstacles.map((centre) => centre.map(decodeSeries));
    this.cell = replay.cell.map((centre) => centre.map(decodeSeries));
    this.closest = replay.closest.map(decodeSeries);
    this.tool = replay.tool.map(decodeSeries);
    this.error = decodeSeries(replay.error);
    this.ratios = replay.velocity_ratio.map(decodeSeries);
  }

  jointsAt(time: number): number[] {
    return this.positions.map((column) => sampleAt(column, this.dt, time));
  }
  /** Returns the velocity ratios; NaN after the end of the run. */
  ratiosAt(time: number): number[] {
    if (time > this.end) return this.ratios.map(() => NaN);
    return this.ratios.map((column) => sampleAt(column, this.dt, time));
  }
  targetAt(time: number): Vec3 | null {
    return this.pointAt(this.target, time);
  }
  obstacleAt(index: number, time: number): Vec3 | null {
    return this.pointAt(this.obstacles[index] ?? [], time);
  }

  partAt(index: number, time: number): Vec3 | null {
    return this.pointAt(this.cell[index] ?? [], time);
  }
  /** Returns the point of the arm with the smallest clearance, and the nearest point that the arm must not
   * touch. */
  closestAt(time: number): [Vec3, Vec3] | null {
    const of = this.pointAt(this.closest.slice(0, 3), time);
    const to = this.pointAt(this.closest.slice(3), time);
    return of === null || to === null || time > this.end ? null : [of, to];
  }

  /** Returns the 98th percentile of the errors. Larger errors have the last colour of the scale. */
  errorScale(): number {
    const errors = Array.from(this.error)
      .filter((value) => Number.isFinite(value) && value > 0)
      .sort((a, b) => a - b);
    return errors[Math.floor(0.98 * (errors.length - 1))] ?? 0;
  }

  /** Returns the time at which a joint came closest to its velocity limit. */
  peakTime(): number {
    let [largest, at] = [-1, 0];
    for (const column of this.ratios) {
      column.forEach((ratio, i) => {
        if (ratio > largest) [largest, at] = [ratio, i];
      });
    }
    return at * this.dt;
  }

  private pointAt(columns: Float64Array[], time: number): Vec3 | null {
    const [x, y, z] = columns.map((column) => sampleAt(column, this.dt, time));
    if (x === undefined || y === undefined || z === undefined || Number.isNaN(x + y + z)) return null;
    return [x, y, z];
  }
}
