// The replay columns of one run, decoded, and their values at any time.
import type { Run, Vec3 } from "../data";
import { decodeSeries, sampleAt } from "../decode";

export class Recording {
  readonly dt: number;
  readonly n: number;
  /** s; from then on the last sample is held. */
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
  /** No values after the end: what is held has no velocity. */
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
  /** The point of the arm that is closest to what it must not touch, and the point that it is closest to. */
  closestAt(time: number): [Vec3, Vec3] | null {
    const of = this.pointAt(this.closest.slice(0, 3), time);
    const to = this.pointAt(this.closest.slice(3), time);
    return of === null || to === null || time > this.end ? null : [of, to];
  }

  /** An error that nearly all of the run stays below; the few peaks beyond it take the last colour. */
  errorScale(): number {
    const errors = Array.from(this.error)
      .filter((value) => Number.isFinite(value) && value > 0)
      .sort((a, b) => a - b);
    return errors[Math.floor(0.98 * (errors.length - 1))] ?? 0;
  }

  /** When a joint came closest to its velocity limit. */
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
