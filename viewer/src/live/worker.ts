/** Runs in a worker, behind the script of the core: computes piece by piece, so that messages are heard in between. */
import type { ProtrusionRow } from "../contract";
import { buffersOf, type Answer, type CoreFrame, type CoreMatrix, type Fault, type FromWorker, type Given, type Head, type Law, type Preset, type ToWorker, type TrackRow } from "./protocol";

/** As web/core/bindings.cpp exports it; all text is JSON. */
interface Core {
  putFile(name: string, content: string): void;
  check(toml: string, overrides: string): string;
  /** @param image  a state that was kept, to go on from; "": the beginning */
  start(toml: string, overrides: string, image: Uint8Array | ""): string;
  /** @param wall_ms  returns after about so long, at the soonest after a step, or when t_end is reached */
  march(t_end: number, wall_ms: number): string;
  change(overrides: string): string;
  matrix(): CoreMatrix;
  /** @param spare  a frame that nobody reads any more, whose arrays may be used again */
  frame(spare: CoreFrame | undefined): CoreFrame;
  tracks(): string;
  protrusions(): string;
  image(): Uint8Array;
  presets(): string;
  laws(): string;
}

declare function matrigrateCore(options: object): Promise<Core>;

type Moment = Pick<Head, "t_s" | "done">;

interface Refusal {
  faults?: Fault[];
  failure?: string;
}

/** Computes so long before it listens [ms]. */
const piece = 30;
/** Least time between two pictures [ms]. */
const between = 90;

const send = (message: FromWorker, transfer: Transferable[] = []): void =>
  (self as unknown as { postMessage(m: unknown, t: Transferable[]): void }).postMessage(message, transfer);

let core: Core;
let playing = false;
let waiting = false; // for the page to take the last picture over
let target = Infinity;
let lastFrame = 0;
/** The picture before, once the page has taken it over. */
let spare: CoreFrame | undefined;
/** Rows of protrusions as they were last told. */
let told = "";
const heartbeat = new MessageChannel();

const read = <T>(text: string): T & Refusal => JSON.parse(text) as T & Refusal;

/** True if the core refused or failed; the page then gets the reason. */
function refused(answer: Refusal, of: "start" | "change"): boolean {
  if (answer.faults) send({ kind: "faults", faults: answer.faults, of });
  else if (answer.failure) send({ kind: "failure", text: answer.failure });
  return answer.faults !== undefined || answer.failure !== undefined;
}

function show(done: boolean): void {
  const frame = core.frame(spare);
  spare = undefined;
  const tracks = read<TrackRow[]>(core.tracks());
  const rows = core.protrusions();
  const protrusions = rows === told ? undefined : read<ProtrusionRow[]>(rows);
  told = rows;
  waiting = true;
  lastFrame = performance.now();
  send({ kind: "frame", frame, tracks, protrusions, done }, buffersOf(frame));
}

/** Where the simulation is, which may be later than what has been shown. */
const here = () => read<Moment>(core.march(0, 0));

function stop(why: "paused" | "done" | "failed"): void {
  playing = false;
  send({ kind: "stopped", why });
}

function compute(): void {
  if (!playing) return;
  const now = read<Moment>(core.march(target, piece));
  if (refused(now, "start")) return stop("failed");
  const there = now.t_s >= target - 1e-6;
  if (now.done || there || (!waiting && performance.now() - lastFrame >= between)) show(now.done);
  if (now.done || there) stop(now.done ? "done" : "paused");
  else heartbeat.port2.postMessage(null);
}

function put(given: Given): void {
  for (const [name, content] of Object.entries(given.files)) core.putFile(`/${name}`, content);
}

function begin(given: Given, image: Uint8Array | "" = ""): void {
  put(given);
  const head = read<Head>(core.start(given.toml, JSON.stringify(given.overrides), image));
  if (refused(head, "start")) return;
  playing = false;
  told = "";
  send({ kind: "begun", head, matrix: core.matrix() });
  show(head.done);
}

function act(message: ToWorker): void {
  switch (message.kind) {
    case "check": {
      put(message.given);
      const { toml, overrides } = message.given;
      const found = read<Pick<Answer, "changed" | "toml">>(core.check(toml, JSON.stringify(overrides)));
      return send({ kind: "answer", ticket: message.ticket, ...found });
    }
    case "start":
      return begin(message.given, message.image);
    case "play":
      target = message.to_s ?? Infinity;
      if (playing) return;
      playing = true;
      return heartbeat.port2.postMessage(null);
    case "pause":
      if (!playing) return;
      show(here().done);
      return stop("paused");
    case "step": {
      playing = false;
      const now = read<Moment>(core.march(Infinity, 0));
      if (!refused(now, "start")) show(now.done);
      return;
    }
    case "change": {
      const head = read<Head>(core.change(JSON.stringify(message.overrides)));
      if (refused(head, "change")) return;
      send({ kind: "changed", head, matrix: core.matrix(), overrides: message.overrides });
      if (!playing) show(head.done);
      return;
    }
    case "image": {
      const bytes = core.image();
      return send({ kind: "answer", ticket: message.ticket, bytes, t_s: here().t_s }, [bytes.buffer as ArrayBuffer]);
    }
    case "seen":
      waiting = false;
      spare = message.frame;
  }
}

heartbeat.port1.onmessage = compute;
// What the browser cannot do is said in words, too: no SIMD, no memory.
matrigrateCore({}).then(
  (made) => {
    core = made;
    self.onmessage = (event: MessageEvent<ToWorker>) => act(event.data);
    send({ kind: "ready", presets: read<Preset[]>(core.presets()), laws: read<Law[]>(core.laws()) });
  },
  (reason: unknown) => {
    const text = `This browser cannot run the simulation (WebAssembly with SIMD is needed): ${String(reason)}`;
    send({ kind: "failure", text });
  },
);
