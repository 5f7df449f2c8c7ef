import { el } from "./dom";
import { extentOf } from "./extent";
import { keyHelp } from "./keys";
import { Panel } from "./panel";
import { Playback, steppedTime } from "./playback";
import { Plots } from "./plots";
import type { Loaded } from "./run";
import { ScenePage } from "./scene_page";
import { RecordedSource } from "./source";
import { Transport } from "./transport";

/** The numbers beside the scene change at most this often while playing [ms]. */
const numbersPause = 100;

/** The page of stored runs: scene, panel, transport, plots, and what happens between them. */
export class App extends ScenePage<RecordedSource> {
  readonly element: HTMLElement;
  readonly playback: Playback;
  readonly plots: Plots;
  protected readonly panel: Panel;
  private readonly transport: Transport;
  private lastFrame = 0;

  constructor(loaded: Loaded) {
    const [run, second] = loaded.runs;
    const source = new RecordedSource(run), ghost = second && new RecordedSource(second);
    super(source, ghost, extentOf(source.header, source.frames), keyHelp);
    const { times, header } = this.source;
    this.playback = new Playback(times[0], times[times.length - 1]);
    this.transport = new Transport(this.playback, this.source.events, header.output_interval, {
      toggle: () => this.toggle(),
      step: (frames) => this.step(frames),
      seek: (time) => this.seek(time),
      showEvent: (index) => this.showEvent(index),
      nextImpact: (direction) => this.nextImpact(direction),
    });
    this.panel = new Panel(this.source, this.shown, ghost !== undefined, {
      select: (body) => this.select(body),
      follow: (body) => this.follow(body),
      changed: () => this.invalidate(),
      showDeepest: () => this.showDeepest(),
    });
    this.plots = new Plots(this.source, ghost, (time) => this.seek(time));
    this.element = el("div", { class: "app" }, this.head(), ...loaded.problems.map((problem) => el("p", { class: "problem", role: "alert", text: problem })),
      el("div", { class: "middle" }, this.stage, this.panel.element), this.transport.element, this.plots.element, this.help);
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

  private head(): HTMLElement {
    const { header } = this.source;
    const method = header.audit.method as Record<string, string> | undefined;
    const choices = [method?.scheme, method?.integrator, method?.impact].filter(Boolean).join(" · ");
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
    const elapsed = Math.min(0.25, (now - this.lastFrame) / 1000);
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
