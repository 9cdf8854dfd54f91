// Drives a browser without a window through its debugging pipe. The program contains this file (cmake/pages.cmake) and
// calls it, so that the page of a run draws what `matrigrate export` writes.
//   node drive.mjs JOB     a JSON file: {"browser": PROGRAM, "folder": FOLDER, "scale": 1, "show": {},
//                          "movie": {} or "frames": [[number, time]] or "panel": []}; FOLDER has page.html, and made/ for the results
// Needs Node.js 18 and no packages.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pipeline } from "node:stream/promises";
import { fileURLToPath, pathToFileURL } from "node:url";

const options =
  "--headless --remote-debugging-pipe --disable-gpu --disable-dev-shm-usage --no-first-run --disable-background-networking " +
  "--disable-component-update --disable-default-apps --disable-extensions --disable-sync --hide-scrollbars --mute-audio " +
  "--disable-background-timer-throttling --disable-renderer-backgrounding";

/** The last line that a stream has said so far. */
function lastLine(stream) {
  let text = "";
  stream.on("data", (piece) => (text = (text + piece).slice(-10000)));
  return () => text.trim().split("\n").at(-1);
}

export class Browser {
  #sent = 0;
  /** What is awaited: answers by the number of the message, the end of loading by session. */
  #awaited = new Map();

  /** @param folder  for its profile */
  constructor(program, folder) {
    const root = process.getuid() === 0 ? ["--no-sandbox"] : []; // it refuses to run as root with one
    const words = [...options.split(" "), ...root, `--user-data-dir=${folder}`, "about:blank"];
    this.process = spawn(program, words, { stdio: ["ignore", "ignore", "pipe", "pipe", "pipe"] });
    const [, , output, input, answers] = this.process.stdio;
    const said = lastLine(output);
    const gone = (reason) => {
      this.fault = new Error(`the browser ended${reason ? `; it said: ${reason}` : " without a word"}`);
      for (const { failed } of this.#awaited.values()) failed(this.fault);
    };
    this.ended = new Promise((done) => {
      this.process.on("error", (fault) => done(gone(fault.message))).on("close", () => done(gone(said())));
    });
    input.on("error", () => {}); // it has ended
    let pieces = [];
    answers.on("data", (piece) => {
      let begin = 0;
      for (let end; (end = piece.indexOf(0, begin)) >= 0; begin = end + 1) {
        this.#receive(JSON.parse(Buffer.concat([...pieces, piece.subarray(begin, end)]).toString()));
        pieces = [];
      }
      pieces.push(piece.subarray(begin));
    });
  }

  #receive({ id, method, sessionId, result, error }) {
    const key = method === "Page.loadEventFired" ? sessionId : id;
    const { done, failed } = this.#awaited.get(key) ?? {};
    this.#awaited.delete(key);
    if (error) failed?.(new Error(`the browser refuses a command: ${error.message}`));
    else done?.(result);
  }

  #await(key) {
    return new Promise((done, failed) => (this.fault ? failed(this.fault) : this.#awaited.set(key, { done, failed })));
  }

  #send(method, params, sessionId) {
    const answer = this.#await(++this.#sent);
    this.process.stdio[3].write(`${JSON.stringify({ id: this.#sent, method, params, sessionId })}\0`);
    return answer;
  }

  /** Opens a file and waits until it is loaded.   @return  evaluates an expression in the page, and waits for promises */
  async open(file, width, height, deviceScaleFactor = 1) {
    const { targetId } = await this.#send("Target.createTarget", { url: "about:blank", newWindow: true });
    const { sessionId } = await this.#send("Target.attachToTarget", { targetId, flatten: true });
    const send = (method, params = {}) => this.#send(method, params, sessionId);
    await send("Page.enable");
    await send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor, mobile: false });
    const features = [
      { name: "prefers-color-scheme", value: "light" },
      { name: "prefers-reduced-motion", value: "reduce" }, // it does not play by itself
    ];
    await send("Emulation.setEmulatedMedia", { features });
    const loaded = this.#await(sessionId);
    await Promise.all([send("Page.navigate", { url: pathToFileURL(file).href }), loaded]);
    return async (expression) => {
      const asked = { expression, awaitPromise: true, returnByValue: true };
      const { result, exceptionDetails: thrown } = await send("Runtime.evaluate", asked);
      if (thrown) throw new Error(`the page: ${thrown.exception?.description ?? thrown.text}`);
      return result.value;
    };
  }

  async close() {
    this.#send("Browser.close").catch(() => {});
    const impatient = setTimeout(() => this.process.kill(), 3000);
    await this.ended;
    clearTimeout(impatient);
  }
}

/** A picture of the page as bytes, at a time of the run [s]. */
async function picture(page, time, type, quality) {
  const address = await page(`matrigrate.frame(${time}).toDataURL("image/${type}", ${quality})`);
  return Buffer.from(address.slice(address.indexOf(",") + 1), "base64");
}

/** The pictures of a movie in order; some are asked for before the first of them is there. */
async function* filmed(pages, { first, last, count }) {
  const ahead = 4;
  const asked = [];
  for (let k = 0; k < count + ahead; ++k) {
    if (k >= ahead) yield await asked.shift();
    if (k >= count) continue;
    const drawn = picture(pages[k % pages.length], first + ((last - first) * k) / (count - 1), "jpeg", 0.95);
    drawn.catch(() => {}); // it is told when its turn comes
    asked.push(drawn);
  }
}

async function movie(pages, wanted, folder) {
  const input = `-loglevel error -y -f image2pipe -c:v mjpeg -framerate ${wanted.fps} -i -`;
  const video = "-c:v libx264 -preset veryfast -crf 18 -vf scale=in_range=pc:out_range=tv:out_color_matrix=bt709,format=yuv420p";
  const colours = "-colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv -movflags +faststart";
  const words = [...`${input} ${video} ${colours}`.split(" "), join(folder, "movie.mp4")];
  const ffmpeg = spawn("ffmpeg", words, { stdio: ["pipe", "ignore", "pipe"] });
  const said = lastLine(ffmpeg.stderr);
  const ended = once(ffmpeg, "close");
  const fault = await pipeline(filmed(pages, wanted), ffmpeg.stdin).catch((reason) => reason);
  const [code] = await ended;
  if (fault && fault.code !== "EPIPE") throw fault;
  if (code !== 0) throw new Error(`ffmpeg ended with exit code ${code}: ${said()}`);
}

async function draw({ browser: program, folder, show, scale, movie: film, frames, panel }) {
  const browser = new Browser(program, join(folder, "profile"));
  try {
    const pages = [];
    for (let i = 0; i < (film ? 2 : 1); ++i) pages.push(await browser.open(join(folder, "page.html"), show.width, show.height, scale));
    for (const one of pages) await one(`matrigrate.ready.then(() => matrigrate.show(${JSON.stringify(show)}))`);
    const made = join(folder, "made");
    if (film) await movie(pages, film, made);
    for (const [k, time] of frames ?? []) {
      const name = join(made, `frame_${String(k).padStart(4, "0")}`);
      writeFileSync(`${name}.png`, await picture(pages[0], time, "png"));
      writeFileSync(`${name}.svg`, await pages[0](`matrigrate.svg(${time})`));
    }
    if (panel) writeFileSync(join(made, "panel.svg"), await pages[0](`matrigrate.panel(${JSON.stringify(panel)})`));
  } finally {
    await browser.close();
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  draw(JSON.parse(readFileSync(process.argv[2], "utf8"))).catch((reason) => {
    console.error(reason.message);
    process.exitCode = 1;
  });
