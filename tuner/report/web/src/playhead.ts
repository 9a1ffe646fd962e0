// The playhead of a scenario: the time that its replay and all its plots show.

type Listener = (time: number) => void;

/** Speeds of the replay, relative to real time. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8];

/** Returns the speed at which a short motion takes at least three seconds, so that one can follow it. */
export function speedFor(duration: number): number {
  const LONG_ENOUGH = 3;  // s
  const slow = SPEEDS.filter((speed) => speed <= 1 && duration / speed >= LONG_ENOUGH);
  return slow.length > 0 ? Math.max(...slow) : Math.min(...SPEEDS);
}

export class Playhead {
  private now = 0;
  private running = false;
  private rate: number;
  private before = 0;
  private frame = 0;
  private readonly listeners = new Set<Listener>();
  private readonly playListeners = new Set<(playing: boolean) => void>();

  constructor(readonly duration: number) {
    this.rate = speedFor(duration);
  }

  get time(): number {
    return this.now;
  }
  get playing(): boolean {
    return this.running;
  }
  get speed(): number {
    return this.rate;
  }
  set speed(rate: number) {
    this.rate = rate;
  }

  onTime(listener: Listener): void {
    this.listeners.add(listener);
    listener(this.now);
  }
  onPlaying(listener: (playing: boolean) => void): void {
    this.playListeners.add(listener);
    listener(this.running);
  }

  seek(time: number): void {
    const kept = Math.min(Math.max(time, 0), this.duration);
    if (kept === this.now || Number.isNaN(kept)) return;
    this.now = kept;
    for (const listener of this.listeners) listener(kept);
  }

  toggle(): void {
    if (this.running) this.pause();
    else this.play();
  }

  play(): void {
    if (this.running) return;
    if (this.now >= this.duration) this.seek(0);
    this.running = true;
    this.before = performance.now();
    this.frame = requestAnimationFrame(this.step);
    this.tellPlaying();
  }

  pause(): void {
    if (!this.running) return;
    this.running = false;
    cancelAnimationFrame(this.frame);
    this.tellPlaying();
  }

  private readonly step = (now: number): void => {
    // A hidden page gets no frames. The time that it missed is not made up for.
    const passed = Math.min(Math.max(now - this.before, 0), 250) / 1000;
    this.before = now;
    this.seek(this.now + passed * this.rate);
    if (this.now >= this.duration) this.pause();
    else if (this.running) this.frame = requestAnimationFrame(this.step);
  };

  private tellPlaying(): void {
    for (const listener of this.playListeners) listener(this.running);
  }
}
