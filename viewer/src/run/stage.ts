/** The stage: two canvases, matrix below and cell above, one camera, and the gestures that move it. */
import { h, isDark, onDarkMode, onPaper, onPrint, onResize } from "../dom";
import type { RunPage } from "../contract";
import { measuredOf, type Measured } from "../measured";
import { attachGestures, Camera, type Box } from "./camera";
import { displacementScale, type ArrowKind, type Usual } from "./over/arrows";
import { paintCell, type CellScene } from "./over/cell_painter";
import type { Clock } from "./clock";
import { edgeBar, edges, hasColours, type Edge } from "./over/edge";
import { visitedBox, outlineAt, placeAt, type Film, type Place } from "./frames";
import { overlays, type Layer, type OverlayKey, type Shown } from "./matrix/layers";
import type { Pen } from "./over/pen";
import { matrixPainter, type MatrixScene } from "./matrix/painter";
import { isDarkGround, LayerScale, type Coloured, type SharedScales } from "./matrix/scale";
import { fibreLayer, fibreRows } from "./over/fibres";
import { resample, valueOfNearest, valueOn, type Patch } from "./matrix/resample";

/** A picture of the stage as it is. */
export interface View {
  camera: Camera;
  /** Pixels of the canvases in a pixel of the page. */
  pixels: number;
  matrix: HTMLCanvasElement;
  top: HTMLCanvasElement;
  /** What colours stand for: the layer; where they are drawn, the strain of fibres and the edge of the cell. */
  bars: Coloured[];
  title: string;
  time: number;
  dark: boolean;
}

/** What is told of: another layer, another state of the view, limits that another run has changed, a picture that was painted. */
type Event = "layer" | "view" | "scale" | "paint";

export class Stage {
  readonly element: HTMLElement;
  readonly shown = Object.fromEntries(overlays.map((o) => [o.key, o.on])) as Shown;
  readonly camera: Camera;
  layer: Layer;
  follow = false;
  edge: Edge;
  /** The matrix as a field between the particles, not as the particles themselves. */
  smooth = true;
  arrows: ArrowKind = "displacement";
  private queued = false;
  /** It has had no size yet. */
  private unseen = true;
  private readonly top = h("canvas", { class: "cell" });
  private readonly home: Box;
  private readonly matrix = h("canvas", { class: "matrix" });
  private readonly paintMatrix: (scene: MatrixScene) => void;
  private pixels = 1;
  /** Place of the last picture between the stored frames. */
  place: Place = { frame: 0, next: 0, fraction: 0 };
  private patch: Patch | null = null;
  private readonly listeners: Record<Event, (() => unknown)[]> = { layer: [], view: [], scale: [], paint: [] };
  private readonly scales = new Map<Layer, LayerScale>();
  private readonly sharedScales = new Map<Layer, LayerScale>();
  /** Strain of the fibres; null without fibres. */
  readonly fibreLayer: Layer | null;
  /** Of the particles of the matrix [um]. */
  private readonly spacing: number;
  readonly measured: Measured;

  constructor(
    private readonly run: RunPage,
    readonly film: Film,
    readonly clock: Clock,
    /** All layers that the matrix can be coloured by. */
    readonly layers: Layer[],
    private readonly ownUsual: Usual,
    /** With other runs in view. */
    private readonly shared: SharedScales | undefined,
    gone: AbortSignal,
  ) {
    this.layer = layers[0];
    this.fibreLayer = fibreLayer(film);
    this.measured = measuredOf(run.measured);
    const label = "The cell in the matrix. Keys are listed below it.";
    this.element = h("div", { class: "stage", tabindex: 0, role: "group", "aria-label": label }, this.matrix, this.top);
    this.edge = edges(film)[0];
    this.spacing = run.geometry.spacing_um;
    const r = run.geometry.radius_um + this.spacing;
    this.camera = new Camera({ left: -r, right: r, bottom: -r, top: r });
    this.home = visitedBox(film);
    this.paintMatrix = matrixPainter(this.matrix, film, this.spacing);
    attachGestures(this.element, this.camera, (panned) => {
      // After a drag the camera no longer follows the cell.
      if (panned) this.follow = false;
      this.viewChanged();
    });
    clock.onChange(() => this.draw(), gone);
    onDarkMode(() => this.draw(), gone);
    const printed = () => {
      this.fit();
      this.paint();
      if (onPaper()) this.layMatrixUnderCell();
    };
    onPrint(this.element, printed, gone);
    const resized = () => {
      this.fit();
      if (this.unseen) this.camera.show(this.home);
      this.unseen = false;
      this.viewChanged();
    };
    onResize(this.element, resized, gone);
  }

  on(event: Event, listener: () => unknown): void {
    this.listeners[event].push(listener);
  }

  private tell(event: Event): void {
    for (const listener of this.listeners[event]) listener();
  }

  choose(layer: Layer): void {
    this.layer = layer;
    this.tell("layer");
    this.draw();
  }

  /** Colours and limits; of the layer that is shown, if none is named. */
  scale(layer = this.layer): LayerScale {
    const limits = this.shared?.on ? this.shared.of(layer) : undefined;
    const scales = limits ? this.sharedScales : this.scales;
    let scale = scales.get(layer);
    if (!scale) scales.set(layer, (scale = new LayerScale(layer, this.film, limits)));
    return scale;
  }

  /** Limits and colours of the strain of the fibres, which differ from those of the layer beneath; null where none is drawn. */
  get drawnFibres(): LayerScale | null {
    const { fibreLayer: layer } = this;
    if (!layer || !this.shown.fibres) return null;
    const scale = this.scale(layer);
    const taken = this.scale().limits.map;
    scale.limits.map = layer.maps.find((map) => map !== taken) ?? layer.maps[0];
    return scale;
  }

  /** After a person has changed limits or colours here. */
  scaleChanged(): void {
    this.draw();
    if (this.shared?.on) this.shared.tell(this);
  }

  /** Takes part in what runs share. */
  share(gone: AbortSignal): void {
    const changed = () => {
      this.tell("scale");
      this.tell("view");
      this.draw();
    };
    const coloured = this.fibreLayer ? [...this.layers, this.fibreLayer] : this.layers;
    this.shared?.join(this, coloured, this.ownUsual, changed, gone);
  }

  private get usual(): Usual {
    return this.shared?.on ? this.shared.usual : this.ownUsual;
  }

  /** Fibres are drawn at every row of particles of this view (1), every second (2), and so on. */
  fibreRows(): number {
    return this.film.fibres ? fibreRows(this.film.fibres, this.spacing, this.camera) : 1;
  }

  get title(): string {
    return this.run.title;
  }

  /** The value of the layer at a point [um]: null without matrix, NaN in fluid that has no value. */
  valueAt(x: number, y: number): number | null {
    if (this.patch) return valueOn(this.patch, x, y);
    return valueOfNearest(this.film, this.layer, this.place, x, y, this.spacing);
  }

  pan(dx: number, dy: number): void {
    this.follow = false;
    this.camera.pan(dx, dy);
    this.viewChanged();
  }

  viewChanged(): void {
    const { x, y, scale } = this.camera;
    this.element.dataset["view"] = [x, y, scale].map((v) => v.toFixed(3)).join(" ");
    this.tell("view");
    this.draw();
  }

  /** @param box  first view, if left out */
  reset(box = this.home): void {
    this.follow = false;
    this.camera.show(box);
    this.viewChanged();
  }

  showWhole(): void {
    this.reset(this.camera.whole);
  }

  zoom(factor: number): void {
    this.camera.zoom(factor);
    this.viewChanged();
  }

  /** Switches what is drawn over the matrix on or off. */
  toggle(key: OverlayKey): void {
    this.shown[key] = !this.shown[key];
    this.viewChanged();
  }

  /** A size of its own for the picture, whatever room the page has [pixels of the page]; the first view. */
  fix(width: number, height: number): void {
    this.element.style.cssText = `position:fixed;left:0;top:0;border:0;min-height:0;width:${width}px;height:${height}px`;
    this.fit();
    this.unseen = false;
    this.camera.show(this.home);
  }

  setFollow(on: boolean): void {
    this.follow = on;
    if (on) this.camera.scale = Math.max(this.camera.scale, Math.min(this.camera.width, this.camera.height) / 110);
    this.viewChanged();
  }

  /** Times their true length that displacements are drawn. */
  arrowScale(): number {
    return displacementScale(this.usual.displacement, this.camera);
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    this.camera.resize(Math.max(1, width), Math.max(1, height));
    this.resolve(Math.min(2, devicePixelRatio || 1));
  }

  /** @param pixels  of the canvases in a pixel of the page */
  private resolve(pixels: number): void {
    this.pixels = pixels;
    for (const canvas of [this.matrix, this.top]) {
      canvas.width = Math.round(this.camera.width * pixels);
      canvas.height = Math.round(this.camera.height * pixels);
    }
  }

  draw(): void {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame(() => {
      this.queued = false;
      this.paint();
    });
  }

  /** Chromium prints no canvas of many thousand squares, but a picture of it. */
  private layMatrixUnderCell(): void {
    const c = this.top.getContext("2d");
    if (!c) return;
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.globalCompositeOperation = "destination-over";
    c.drawImage(this.matrix, 0, 0);
    c.globalCompositeOperation = "source-over";
  }

  private cellScene(place: Place, dark: boolean): CellScene {
    const { film, camera, shown, edge, arrows, usual, spacing } = this;
    const { tracks } = this.run;
    const { time } = this.clock;
    const darkGround = isDarkGround(this.layer, this.scale().on(dark));
    const fibres = this.drawnFibres?.on(dark) ?? null;
    return { film, place, time, camera, tracks, measured: this.measured.tracks, shown, edge, spacing, arrows, usual, fibres, dark, darkGround };
  }

  /** Paints at once and returns what has been painted; to be used before the browser goes on. */
  view(): View {
    this.paint();
    const { camera, pixels, top } = this;
    const dark = isDark();
    const bars: Coloured[] = [this.scale().bar(dark)];
    if (this.drawnFibres) bars.push(this.drawnFibres.bar(dark));
    if (hasColours(this.edge, this.shown)) bars.push(edgeBar(this.edge));
    return { camera, pixels, matrix: this.matrix, top, bars, title: this.title, time: this.clock.time, dark };
  }

  /** The view at another resolution, for one picture. @param pixels  of the canvases in a pixel of the page */
  viewAt<T>(pixels: number, use: (view: View) => T): T {
    const usual = this.pixels;
    this.resolve(pixels);
    try {
      return use(this.view());
    } finally {
      this.resolve(usual);
      this.paint();
    }
  }

  /** Draws all that lies over the matrix, with another pen. */
  drawOver(pen: Pen): void {
    paintCell(pen, this.cellScene(this.place, isDark()));
  }

  private paint(): void {
    const { film, camera, clock } = this;
    const place = (this.place = placeAt(film.times, clock.time));
    if (this.follow) {
      const outline = outlineAt(film, place);
      camera.x = camera.y = 0;
      for (let i = 0; i < film.outlinePoints; ++i) {
        camera.x += outline[2 * i] / film.outlinePoints;
        camera.y += outline[2 * i + 1] / film.outlinePoints;
      }
    }
    const dark = isDark();
    const { layer } = this;
    const scale = this.scale().on(dark);
    this.patch = this.smooth ? resample(film, layer, place, camera, this.spacing, this.patch?.sums) : null;
    this.paintMatrix({ place, layer, scale, camera, dark, patch: this.patch, pixels: this.pixels });
    const c = this.top.getContext("2d");
    if (!c) return;
    c.setTransform(this.pixels, 0, 0, this.pixels, 0, 0);
    c.clearRect(0, 0, camera.width, camera.height);
    paintCell(c, this.cellScene(place, dark));
    this.tell("paint");
  }
}
