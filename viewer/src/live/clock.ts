/** The time that is shown: at the front it follows the simulation, a little behind so that motion is smooth. */
import { Clock } from "../run/clock";

type Engine = Record<"play" | "pause" | "step", () => void>;

export class LiveClock extends Clock {
  /** True while the view follows the simulation; false while a person looks at the past. */
  atFront = true;
  private before = 0;
  /** Model seconds in a second of watching, as measured. */
  rate = 0;
  private arrived = { at: 0, t: 0 };
  private ticking = false;

  constructor(
    times: number[],
    private readonly engine: Engine,
  ) {
    super(0, times);
  }

  /** A new simulation, or one taken up. */
  begin(t: number): void {
    this.end = t;
    this.rate = 0;
    this.arrived = { at: performance.now(), t };
    this.toFront();
  }

  /** A moment has come from the simulation. */
  arrive(t: number): void {
    const now = performance.now();
    const [dt, wall] = [t - this.arrived.t, (now - this.arrived.at) / 1000];
    if (dt > 0 && wall > 0 && this.playing) {
      const share = Math.min(1, wall / 1.5);
      this.rate = this.rate === 0 ? dt / wall : this.rate + share * (dt / wall - this.rate);
    }
    this.arrived = { at: now, t };
    this.end = t;
    if (this.atFront && !this.playing) this.time = t;
    this.tell();
  }

  /** Told by the simulation. */
  running(on: boolean): void {
    this.playing = on;
    if (on) {
      this.arrived.at = performance.now();
      if (!this.ticking) {
        this.ticking = true;
        this.before = performance.now();
        requestAnimationFrame(this.run);
      }
    } else if (this.atFront) this.time = this.end;
    this.tell();
  }

  toFront(): void {
    this.atFront = true;
    this.time = this.end;
    this.tell();
  }

  override set(time: number): void {
    this.atFront = time >= this.end;
    super.set(time);
  }

  override jump(time: number): void {
    this.set(time);
  }

  override step(direction: 1 | -1): void {
    if (direction > 0 && this.time >= this.end - 1e-6) this.engine.step();
    else super.step(direction);
  }

  override toggle(): void {
    if (this.playing) this.engine.pause();
    else {
      this.toFront();
      this.engine.play();
    }
  }

  private run = (now: number): void => {
    if (!this.playing) {
      this.ticking = false;
      return;
    }
    requestAnimationFrame(this.run);
    const passed = Math.min(0.1, Math.max(0, (now - this.before) / 1000));
    this.before = now;
    if (!this.atFront) return;
    // About a fifth of a second behind the newest moment; faster or slower as that distance is larger or smaller.
    const wanted = 0.2 * this.rate;
    const lag = this.end - this.time;
    const pace = this.rate + 1.5 * (lag - wanted);
    const next = Math.min(this.end, this.time + Math.max(0, pace) * passed);
    this.time = lag > 5 * wanted + 60 ? this.end - wanted : next;
    this.tell();
  };
}
