/** The time that everything on the page shows: player, plots and timeline follow it and may set it. */

export class Clock {
  time = 0;
  playing = false;
  /** Model seconds in a second of watching. */
  speed = 1200;
  /** True if the clock starts again at its end. */
  loop = false;
  private readonly listeners = new Set<() => void>();
  private last = 0;

  /** @param end  moves on while a simulation is followed live */
  constructor(
    public end: number,
    readonly stops: number[],
  ) {}

  /** @param gone  when the listener is no longer wanted */
  onChange(listener: () => void, gone: AbortSignal): void {
    this.listeners.add(listener);
    gone.addEventListener("abort", () => this.listeners.delete(listener));
  }

  get listening(): number {
    return this.listeners.size;
  }

  protected tell(): void {
    for (const listener of this.listeners) listener();
  }

  set(time: number): void {
    this.time = Math.min(this.end, Math.max(0, time));
    this.tell();
  }

  /** From a plot or a key: a person has chosen a time and wants to look at it. */
  jump(time: number): void {
    this.playing = false;
    this.set(time);
  }

  step(direction: 1 | -1): void {
    const slack = 1e-6 * this.end;
    const next =
      direction > 0 ? this.stops.find((t) => t > this.time + slack) : this.stops.findLast((t) => t < this.time - slack);
    this.jump(next ?? (direction > 0 ? this.end : 0));
  }

  toggle(): void {
    this.playing = !this.playing;
    if (this.playing && this.time >= this.end) this.time = 0;
    if (this.playing) {
      this.last = performance.now();
      requestAnimationFrame(this.tick);
    }
    this.tell();
  }

  private tick = (now: number): void => {
    if (!this.playing) return;
    // A tab that was hidden for a minute should not leap.
    const passed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    this.time = Math.min(this.end, this.time + this.speed * passed);
    if (this.time >= this.end && this.loop) this.time = 0;
    if (this.time >= this.end) this.playing = false;
    else requestAnimationFrame(this.tick);
    this.tell();
  };
}
