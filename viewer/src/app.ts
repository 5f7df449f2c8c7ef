import { compareAudits } from "./compare_audits";
import { ComparePlots } from "./compare_plots";
import { el } from "./dom";
import { extentOf } from "./extent";
import { keyHelp } from "./keys";
import { Panel } from "./panel";
import { Playback, steppedTime } from "./playback";
import { Plots } from "./plots";
import { firstOther } from "./parting";
import { precisionPlots } from "./precision_plots";
import type { Loaded } from "./run";
import { RunChoice, type Chosen } from "./run_choice";
import { runColor } from "./run_names";
import { ScenePage } from "./scene_page";
import { RecordedSource } from "./source";
import { Transport } from "./transport";

/** The numbers beside the scene change at most this often while playing [ms]. */
const numbersPause = 100;

/** The page of one stored run or of several: scene, panel, transport, plots, and what happens between them. */
export class App extends ScenePage<RecordedSource> {
  readonly element: HTMLElement;
  readonly playback: Playback;
  readonly plots: Plots | ComparePlots;
  protected readonly panel: Panel;
  private readonly sources: RecordedSource[];
  private readonly transport: Transport;
  private lastFrame = 0;

  constructor(loaded: Loaded) {
    const sources = loaded.runs.map((run) => new RecordedSource(run));
    // Two runs that go different ways tell more than two that do not.
    const first: Chosen = { a: 0, b: sources.length > 1 ? firstOther(sources) : -1 };
    const [source, ghost] = [sources[0], sources[first.b]] as [RecordedSource, RecordedSource | undefined];
    super(source, ghost, extentOf(source.header, source.frames, source.meshes), keyHelp, runColor(Math.max(0, first.b)));
    this.sources = sources;
    // The time line is that of the longest run: a shorter one stands still at its end.
    const times = sources.map((own) => own.times);
    this.playback = new Playback(Math.min(...times.map((own) => own[0])), Math.max(...times.map((own) => own[own.length - 1])));
    this.transport = new Transport(this.playback, source.events, source.header.output_interval, {
      toggle: () => this.toggle(),
      step: (frames) => this.step(frames),
      seek: (time) => this.seek(time),
      showEvent: (index) => this.showEvent(index),
      nextImpact: (direction) => this.nextImpact(direction),
    });
    this.panel = new Panel(source, this.shown, ghost !== undefined, {
      select: (body) => this.select(body),
      follow: (body) => this.follow(body),
      changed: () => this.invalidate(),
      showDeepest: () => this.showDeepest(),
    });
    const isComparison = sources.length > 1;
    const seek = (time: number) => this.seek(time);
    this.plots = isComparison ? new ComparePlots(sources, first, seek) : new Plots(source, seek);
    // While the page is out of sight no frame is asked for, and no time passes.
    document.addEventListener("visibilitychange", () => (this.lastFrame = performance.now()));
    const choice = isComparison ? new RunChoice(sources, first, (chosen) => this.showRuns(chosen)).element : undefined;
    this.element = el("main", { class: isComparison ? "app comparison" : "app" }, this.head(), choice, ...loaded.problems.map((problem) => el("p", { class: "problem", role: "alert", text: problem })),
      el("div", { class: "middle" }, this.stage, this.panel.element), this.transport.element, this.plots.element,
      loaded.precision ? precisionPlots(loaded.precision) : undefined, isComparison ? compareAudits(sources) : undefined, this.help);
  }

  toggle(): void {
    this.playback.toggle();
    this.setEvent(undefined);
    this.invalidate();
  }

  seek(time: number): void {
    this.setEvent(undefined);
    this.flagged = [];
    this.playback.seek(time);
    this.invalidate();
  }

  step(frames: number): void {
    this.playback.isPlaying = false;
    this.seek(steppedTime(this.source.times, this.playback.time, frames));
  }

  /** Stops at an event and shows what happened. */
  showEvent(index: number): void {
    const event = this.source.events[index];
    this.playback.isPlaying = false;
    this.playback.seek(event.time);
    this.setEvent(event);
    this.invalidate();
  }

  nextImpact(direction: 1 | -1): void {
    const index = this.transport.line.impactFrom(this.playback.time, direction);
    if (index !== undefined) this.showEvent(index);
  }

  /** Draws one run, and another as its ghost; what is chosen and followed stays, if it is in both. */
  showRuns({ a, b }: Chosen): void {
    const twinOf = (body: number) => (body < 0 ? -1 : this.sources[a].header.bodies.findIndex(({ name }) => name === this.source.header.bodies[body].name));
    const selected = twinOf(this.selected), followed = twinOf(this.view?.followed ?? -1);
    this.source = this.sources[a];
    this.ghost = this.sources[b];
    this.setEvent(undefined);
    this.flagged = [];
    this.view?.setRuns(this.source, this.ghost, extentOf(this.source.header, this.source.frames, this.source.meshes), this.playback.time, runColor(b));
    this.panel.setSource(this.source);
    this.transport.setEvents(this.source.events);
    if (this.plots instanceof ComparePlots) this.plots.setRuns({ a, b });
    this.select(selected);
    if (followed >= 0) this.follow(followed);
  }

  private head(): HTMLElement {
    const { header } = this.source;
    const method = header.audit.method as Record<string, string> | undefined;
    // The many-body path has a law of its own for all but its solver.
    const chosen = method?.solver === "substep" ? [method.scheme, method.solver] : [method?.scheme, method?.integrator, method?.impact];
    const choices = this.sources.length > 1 ? `${this.sources.length} runs` : chosen.filter(Boolean).join(" · ");
    return el("header", {},
      el("h1", { text: header.scene }),
      el("span", { class: "about", text: `${choices} · ${header.bodies.length} ${header.bodies.length === 1 ? "body" : "bodies"} · ${this.source.times.length} frames` }),
      this.tools());
  }

  protected get time(): number {
    return this.playback.time;
  }

  protected frame(now: number): void {
    requestAnimationFrame((next) => this.frame(next));
    const elapsed = (now - this.lastFrame) / 1000;
    this.lastFrame = now;
    if (this.playback.advance(elapsed)) {
      this.isDirty = true;
      if (this.view?.noteFrameTime(elapsed)) this.resize();
    }
    if (!this.isDirty) return;
    this.isDirty = false;
    this.draw(now);
  }

  private draw(now: number): void {
    const { time, isPlaying } = this.playback;
    this.drawScene();
    this.transport.update();
    if (isPlaying && now - this.lastNumbers < numbersPause) return;
    this.lastNumbers = now;
    this.plots.setTime(time);
    if (this.view) this.panel.showBody(this.selected, this.view.motion, this.selected < 0 ? [] : this.source.contactsAt(time), this.view.followed);
  }

  protected invalidate(): void {
    super.invalidate();
    this.lastNumbers = 0;
  }

  protected redrawTicks(): void {
    this.transport.line.drawTicks();
  }

  /** Goes to the deepest penetration of the run and marks its two bodies. */
  private showDeepest(): void {
    const { audit, bodies } = this.source.header;
    const penetration = audit.penetration as { time: number | null; bodies: string[] | null } | undefined;
    if (penetration?.time == null) return;
    this.playback.isPlaying = false;
    this.seek(penetration.time);
    this.flagged = (penetration.bodies ?? []).map((name) => bodies.findIndex((body) => body.name === name));
  }

  protected keys(event: KeyboardEvent): Record<string, () => void> {
    const many = event.shiftKey ? 10 : 1;
    return {
      " ": () => this.toggle(),
      ArrowLeft: () => this.step(-many),
      ArrowRight: () => this.step(many),
      Home: () => this.seek(this.playback.begin),
      End: () => this.seek(this.playback.end),
      "[": () => this.nextImpact(-1),
      "]": () => this.nextImpact(1),
      "-": () => this.playback.changeSpeed(-1),
      "+": () => this.playback.changeSpeed(1),
      "=": () => this.playback.changeSpeed(1),
      l: () => (this.playback.isLooping = !this.playback.isLooping),
      P: () => this.showDeepest(),
    };
  }
}
