/** Joins the worker, what is set, what is shown and what is kept. */
import type { ProtrusionRow } from "../contract";
import { h, messageOf, wantsStillness } from "../dom";
import { timeText } from "../numbers";
import { copyLink } from "../run/save/link";
import { download } from "../run/save/saving";
import { bar } from "./bar";
import { brush } from "./brush";
import { LiveClock } from "./clock";
import { controls } from "./controls";
import { EngineWorker } from "./engine";
import { exported, keep, type Kept, kept } from "./keep";
import { LiveFilm } from "./film";
import { lesson } from "./lesson";
import { results, resultsOf } from "./results";
import { buffersOf, type Answer, type Changed, type CoreMatrix, type FromWorker, type Head } from "./protocol";
import { addTracks, noTracks, scene, viewOf, type Scene, type View } from "./scene";
import { drawnFiles, fresh, fromHash, given, now, pascals, toHash, type Ground, type Scenario } from "./scenario";
import { Troubles } from "./troubles";

declare global {
  interface Window {
    matrigrateLive?: Live;
  }
}

/** Between two times that it is kept by itself [ms]. */
const keepEvery = 30_000;
const hour = 3600;

/** On phones and tablets: browsers there stop tabs that nobody sees. */
const inFront = (): string =>
  matchMedia("(pointer: coarse)").matches ? "Keep this tab in front: a phone or tablet stops it behind. What is computed is saved when you leave." : "";

const settingsOf = (changed: Changed) => Object.fromEntries(changed.map(({ path, value }) => [path, String(value)]));

export class Live {
  readonly parts: HTMLElement[];
  private isSeen = (): void => undefined;
  /** Fulfilled once something is shown. */
  readonly seen = new Promise<void>((done) => (this.isSeen = done));
  readonly clock: LiveClock;
  film: LiveFilm | null = null;
  protrusions: ProtrusionRow[] = [];
  tracks = noTracks();
  /** Number of pictures drawn so far, for measurements. */
  painted = 0;
  private readonly engine: EngineWorker;
  private readonly times: number[] = [];
  private scenario: Scenario = fresh();
  /** The scenario that was sent to the core and is not yet confirmed. */
  private wanted: { scenario: Scenario; kept?: Kept; play: boolean } | null = null;
  /** The fault of the address, until it has been shown. */
  private wrongAddress = "";
  private head: Head | null = null;
  private matrix: CoreMatrix = { reference: new Float32Array() };
  private shown: Scene | null = null;
  private view: View | null = null;
  private gone = new AbortController();
  private lastKept = performance.now();
  private keeping = false;
  private readonly holder = h("div", {}, h("p", { class: "wait", role: "status" }, "Compiling the simulation \u2026"));
  private readonly side = h("div", {});
  private readonly below = h("div", {});
  private readonly troubles = new Troubles();
  private readonly brush = brush(
    (stroke) => void this.begin({ ...this.settled(), strokes: [...this.scenario.strokes, stroke] }, this.clock.playing),
    () => void this.begin({ ...this.settled(), strokes: [] }, this.clock.playing),
  );
  private readonly controls = controls({
    preset: (overrides) => void this.begin(fresh(overrides, this.scenario.settings["run.seed"]), true),
    seed: (seed) => void this.begin({ ...this.settled(), settings: { ...now(this.scenario), "run.seed": seed } }, this.clock.playing),
    set: (path, value) => this.set(path, value),
    toml: (toml) => void this.begin({ toml, settings: {}, strokes: [], changes: [] }, true),
  });
  private readonly lesson = lesson();
  private readonly results = results(() => this.result());
  private readonly bar: ReturnType<typeof bar>;

  constructor() {
    this.engine = new EngineWorker((message) => void this.hear(message));
    this.clock = new LiveClock(this.times, {
      play: () => this.play(),
      pause: () => this.engine.tell({ kind: "pause" }),
      step: () => this.engine.tell({ kind: "step" }),
    });
    const stage = () => this.shown?.stage ?? null;
    this.bar = bar(this.clock, stage, () => this.gone.signal, {
      reset: () => void this.begin(this.settled(), false),
      goOn: () => this.goOn(),
      keep: () => void this.keep(true),
      link: () => void copyLink(toHash(this.settled()), this.bar.tell),
      exported: () => void this.export(),
    });
    const screen = h("div", { class: "screen" }, this.holder, this.bar.element, this.brush.element, this.below);
    const aside = h("div", { class: "aside" }, this.lesson.element, this.controls.element, this.results.element, this.side);
    const player = h("div", { class: "player" }, screen, aside);
    this.parts = [this.troubles.element, h("section", { class: "run-player", "aria-label": "Live simulation" }, player)];
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") void this.keep(false);
    });
  }

  /** For tests and the console. */
  state(): { t_s: number; playing: boolean; rate: number; painted: number; frames: number; scenario: Scenario } {
    const { clock, film, scenario, painted } = this;
    return { t_s: clock.end, playing: clock.playing, rate: clock.rate, painted, frames: film?.film.times.length ?? 0, scenario };
  }

  play(to_s?: number): void {
    if (!this.head) return;
    this.engine.tell({ kind: "play", to_s });
    this.clock.running(true);
  }

  /** What came of the run so far. */
  private result() {
    if (!this.head) return [];
    const changes = this.scenario.changes.map(({ t, overrides }) => `at ${timeText(t)}: ${overrides.join(", ").replaceAll("=", " = ")}`);
    const drawn = this.scenario.strokes.length > 0 ? ["with a drawn matrix"] : [];
    return resultsOf(this.tracks, this.clock.end, settingsOf(this.head.changed), [...drawn, ...changes.filter((one) => !one.includes("run.duration"))]);
  }

  /** The scenario as it is now, to begin anew with. */
  private settled(): Scenario {
    return { ...this.scenario, settings: now(this.scenario), changes: [] };
  }

  private async hear(message: Exclude<FromWorker, Answer>): Promise<void> {
    switch (message.kind) {
      case "ready":
        this.controls.presets(message.presets);
        this.lesson.presets(message.presets);
        this.controls.laws(message.laws);
        return this.open();
      case "begun":
        return this.begun(message.head, message.matrix);
      case "changed": {
        const { head, overrides, matrix } = message;
        this.scenario.changes.push({ t: head.t_s, overrides });
        [this.head, this.matrix] = [head, matrix];
        if (this.film && head.bonds_um.length > 0 !== (this.film.film.fibres !== null)) this.newFilm(head);
        else if (matrix.layers?.length) {
          this.film?.setMatrix(matrix);
          this.lookAway(); // its limits are others now
        }
        this.controls.show(settingsOf(head.changed), this.scenario);
        this.troubles.clear();
        return;
      }
      case "frame":
        if (!this.film || !this.head) return;
        this.film.add(message.frame);
        addTracks(this.tracks, message.tracks);
        if (message.protrusions) this.protrusions = message.protrusions;
        this.clock.arrive(message.frame.t_s);
        if (!this.shown) this.look(this.head, this.film);
        this.shown?.curves.changed();
        this.bar.done(message.done);
        this.engine.tell({ kind: "seen", frame: message.frame }, buffersOf(message.frame));
        if (this.clock.playing && performance.now() - this.lastKept > keepEvery) void this.keep(false);
        return;
      case "stopped":
        this.clock.running(false);
        if (message.why === "done") {
          this.bar.tell(`${timeText(this.clock.end)} are done.`);
          this.results.add(this.result());
        }
        if (message.why !== "failed") await this.keep(false);
        return;
      case "faults":
        this.troubles.faults(message.faults, message.of);
        this.refused();
        this.wanted = null;
        return;
      case "failure":
        this.troubles.failure(message.text);
    }
  }

  /** The scenario of the address; null where it has none, or a wrong one. */
  private ofAddress(): Scenario | null {
    this.wrongAddress = "";
    try {
      return fromHash(location.hash);
    } catch (reason) {
      this.wrongAddress = messageOf(reason);
      return null;
    }
  }

  /** Opens the scenario of the address, else the kept simulation, else the baseline. */
  private async open(): Promise<void> {
    const asked = this.ofAddress();
    addEventListener("hashchange", () => {
      const other = this.ofAddress();
      if (other) void this.begin(other, true);
      else if (this.wrongAddress) this.troubles.say(this.wrongAddress);
    });
    const old = await kept().catch(() => undefined);
    const same = old && (asked === null || toHash(asked) === toHash(old.scenario));
    if (old && same) return this.begin(old.scenario, false, old);
    return this.begin(asked ?? fresh(), !wantsStillness());
  }

  /** Young's modulus and lattice of a scenario, for what is drawn on it. Null where it is wrong, which is then said. */
  private async ground(scenario: Scenario): Promise<Ground | null> {
    const bare = given({ ...scenario, strokes: [] }, { youngs_modulus: 0, radius: 0, spacing: 1, set: {} });
    const { changed, faults, failure } = await this.engine.ask({ kind: "check", given: bare });
    if (faults) this.troubles.faults(faults, "start");
    else if (failure) this.troubles.failure(failure);
    if (!changed) return null;
    const settings = settingsOf(changed);
    const length = (path: string, usual: number) => (settings[path] === undefined ? usual : parseFloat(settings[path]));
    return {
      youngs_modulus: settings["ecm.youngs_modulus"] === undefined ? 200 : pascals(settings["ecm.youngs_modulus"]),
      radius: length("ecm.radius", 150),
      spacing: length("ecm.particle_spacing", 2),
      set: settings,
    };
  }

  /** What was asked for cannot be: shows the settings as they are. */
  private refused(): void {
    if (this.head) this.controls.show(settingsOf(this.head.changed), this.scenario, true);
  }

  private async begin(scenario: Scenario, play: boolean, from?: Kept): Promise<void> {
    const start = from ? { ...scenario, settings: now(scenario) } : scenario;
    const ground = await this.ground({ ...scenario, changes: [] });
    if (!ground) {
      if (!this.head) void this.begin(fresh(), false);
      return this.refused();
    }
    this.wanted = { scenario, kept: from, play };
    // Fields that were drawn are those of the start, whatever the stiffness became on the way.
    this.engine.tell({ kind: "start", given: given(start, ground), image: from?.image });
  }

  private begun(head: Head, matrix: CoreMatrix): void {
    const { scenario, kept: from, play } = this.wanted ?? { scenario: this.scenario, play: false };
    this.wanted = null;
    this.scenario = scenario;
    [this.head, this.matrix] = [head, matrix];
    this.tracks = from?.tracks ?? noTracks();
    this.protrusions = from?.protrusions ?? [];
    this.troubles.clear();
    if (this.wrongAddress) this.troubles.say(this.wrongAddress);
    this.wrongAddress = "";
    this.newFilm(head, from);
    this.clock.running(false);
    this.clock.begin(head.t_s);
    this.controls.show(settingsOf(head.changed), scenario);
    this.bar.tell(from ? `Goes on from ${timeText(from.t_s)}, kept ${new Date(from.when).toLocaleString()}. Reset begins anew.` : inFront());
    history.replaceState(null, "", toHash(scenario));
    if (play) this.play();
  }

  /** Disposes of the player; the next frame recreates it with the same view. */
  private lookAway(): void {
    this.gone.abort();
    if (this.shown) this.view = viewOf(this.shown.stage);
    this.shown = null;
  }

  private newFilm(head: Head, from?: Kept): void {
    this.lookAway();
    this.film = new LiveFilm(head, this.matrix);
    this.times.length = 0;
    this.film.film.times = this.times; // the clock steps by them
    if (from?.film) this.film.restore(from.film);
  }

  /** Makes all that shows the film, once it has a moment. */
  private look(head: Head, film: LiveFilm): void {
    this.gone = new AbortController();
    this.shown = scene(head, film, this.clock, this.tracks, () => this.protrusions, this.brush, () => this.scenario.strokes, this.view, this.gone.signal);
    this.shown.stage.on("paint", () => ++this.painted);
    this.holder.replaceChildren(this.shown.stage.element);
    this.side.replaceChildren(...this.shown.aside);
    this.below.replaceChildren(this.shown.curves.element);
    this.isSeen();
  }

  private set(path: string, value: string): void {
    if (this.clock.end === 0) {
      const scenario = this.settled();
      void this.begin({ ...scenario, settings: { ...scenario.settings, [path]: value } }, false);
    } else this.engine.tell({ kind: "change", overrides: [`${path}=${value}`] });
  }

  private goOn(): void {
    const hours = Math.round((this.head?.duration_s ?? 6 * hour) / hour) + 6;
    this.engine.tell({ kind: "change", overrides: [`run.duration=${hours} h`] });
    this.play();
  }

  /** @param asked  by a person */
  private async keep(asked: boolean): Promise<void> {
    if (!this.film || this.keeping) return;
    this.keeping = true;
    this.lastKept = performance.now();
    try {
      const { bytes, t_s } = await this.engine.ask({ kind: "image" });
      if (!bytes || t_s === undefined) return;
      const { scenario, tracks, protrusions } = this;
      await keep({ scenario, t_s, image: bytes, tracks, protrusions, when: Date.now() }, this.film);
      document.documentElement.dataset["kept"] = String(t_s);
      if (asked) this.bar.tell(`Saved in this browser at ${timeText(t_s)}.`);
    } catch (reason) {
      this.bar.tell(`Not saved: ${messageOf(reason)}`);
    } finally {
      this.keeping = false;
    }
  }

  private async export(): Promise<void> {
    const ground = await this.ground(this.scenario);
    if (!ground) return;
    const { toml, failure } = await this.engine.ask({ kind: "check", given: given(this.scenario, ground) });
    if (!toml) return this.troubles.say(failure ?? "The scenario cannot be written.");
    for (const [name, content] of Object.entries(exported(this.scenario, toml, drawnFiles(this.scenario.strokes, ground)))) download(name, content);
  }
}
