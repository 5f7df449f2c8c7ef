import { compareAudits } from "./compare_audits";
import { ComparePlots } from "./compare_plots";
import { button, el } from "./dom";
import { extentOf } from "./extent";
import * as format from "./format";
import { keyHelp } from "./keys";
import { shownAtFirst, vectorAt, type Shown } from "./marks";
import { Panel } from "./panel";
import { Playback, steppedTime } from "./playback";
import { Plots } from "./plots";
import type { Loaded, MotionEvent } from "./run";
import { RunChoice, runColor, type Chosen } from "./run_choice";
import { RecordedSource } from "./source";
import { Transport } from "./transport";
import { View3D } from "./view3d";

/** The numbers beside the scene change at most this often while playing [ms]. */
const numbersPause = 100;

/** The page of one run or of several: scene, panel, transport, plots, and what happens between them. */
export class App {
  readonly element: HTMLElement;
  readonly playback: Playback;
  /** The run that is looked at, and the one that is its ghost. */
  source: RecordedSource;
  ghost: RecordedSource | undefined;
  readonly plots: Plots | ComparePlots;
  /** None where the browser has no WebGL: then all but the scene works. */
  readonly view: View3D | undefined;
  selected = -1;
  private readonly sources: RecordedSource[];
  private readonly shown: Shown = { ...shownAtFirst };
  private readonly panel: Panel;
  private readonly transport: Transport;
  private readonly stage = el("div", { class: "stage" });
  private readonly help: HTMLDialogElement;
  private event: MotionEvent | undefined;
  /** The bodies of the deepest penetration, while it is looked at. */
  private flagged: number[] = [];
  private isDirty = true;
  private lastFrame = 0;
  private lastNumbers = 0;

  constructor(loaded: Loaded) {
    this.sources = loaded.runs.map((run) => new RecordedSource(run));
    [this.source, this.ghost] = this.sources;
    // The time line is that of the longest run: a shorter one stands still at its end.
    const times = this.sources.map((source) => source.times);
    this.playback = new Playback(Math.min(...times.map((own) => own[0])), Math.max(...times.map((own) => own[own.length - 1])));
    this.transport = new Transport(this.playback, this.source.events, this.source.header.output_interval, {
      toggle: () => this.toggle(),
      step: (frames) => this.step(frames),
      seek: (time) => this.seek(time),
      showEvent: (index) => this.showEvent(index),
      nextImpact: (direction) => this.nextImpact(direction),
    });
    this.panel = new Panel(this.source, this.shown, this.ghost !== undefined, {
      select: (body) => this.select(body),
      follow: (body) => this.follow(body),
      changed: () => this.invalidate(),
      showDeepest: () => this.showDeepest(),
    });
    const isComparison = this.sources.length > 1;
    const seek = (time: number) => this.seek(time);
    this.plots = isComparison ? new ComparePlots(this.sources, { a: 0, b: 1 }, seek) : new Plots(this.source, seek);
    const choice = isComparison ? new RunChoice(this.sources, { a: 0, b: 1 }, (chosen) => this.showRuns(chosen)).element : undefined;
    this.help = helpDialog();
    this.view = this.makeView();
    this.element = el("div", { class: isComparison ? "app comparison" : "app" }, this.head(), choice, ...loaded.problems.map((problem) => el("p", { class: "problem", role: "alert", text: problem })),
      el("div", { class: "middle" }, this.stage, this.panel.element), this.transport.element, this.plots.element,
      isComparison ? compareAudits(this.sources) : undefined, this.help);
  }

  /** Starts drawing; the element is in the page. */
  begin(): void {
    this.panel.updateShown();
    this.panel.showEvent(undefined);
    new ResizeObserver(() => this.resize()).observe(this.stage);
    window.addEventListener("keydown", (event) => this.press(event));
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.applyTheme());
    this.resize();
    this.applyTheme();
    requestAnimationFrame((now) => this.frame(now));
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
    const index = this.transport.impactFrom(this.playback.time, direction);
    if (index !== undefined) this.showEvent(index);
  }

  select(body: number): void {
    this.selected = body;
    this.plots.showBody(body);
    if (body < 0) this.view?.startFollowing(-1);
    this.invalidate();
  }

  follow(body: number): void {
    this.view?.startFollowing(this.view.followed === body ? -1 : body);
    this.invalidate();
  }

  /** Draws one run, and another as its ghost; what is chosen and followed stays, if it is in both. */
  showRuns({ a, b }: Chosen): void {
    const twinOf = (body: number) => (body < 0 ? -1 : this.sources[a].header.bodies.findIndex(({ name }) => name === this.source.header.bodies[body].name));
    const selected = twinOf(this.selected), followed = twinOf(this.view?.followed ?? -1);
    this.source = this.sources[a];
    this.ghost = this.sources[b];
    this.setEvent(undefined);
    this.flagged = [];
    this.view?.setRuns(this.source, this.ghost, extentOf(this.source.header, this.source.frames), this.playback.time, runColor(b));
    this.panel.setSource(this.source);
    this.transport.setEvents(this.source.events);
    if (this.plots instanceof ComparePlots) this.plots.setRuns({ a, b });
    this.select(selected);
    if (followed >= 0) this.follow(followed);
  }

  /** Where a body's centre of mass is drawn now, in the world [m]. */
  positionOf(body: number): number[] {
    if (!this.view) return [];
    return vectorAt(this.view.motion.position, body).map((x, c) => x + this.source.header.origin[c]);
  }

  private head(): HTMLElement {
    const { header } = this.source;
    const method = header.audit.method as Record<string, string> | undefined;
    const choices = this.sources.length > 1 ? `${this.sources.length} runs` : [method?.scheme, method?.integrator, method?.impact].filter(Boolean).join(" · ");
    return el("header", {},
      el("h1", { text: header.scene }),
      el("span", { class: "about", text: `${choices} · ${header.bodies.length} ${header.bodies.length === 1 ? "body" : "bodies"} · ${this.source.times.length} frames` }),
      el("span", { class: "tools" },
        button("⌂", "Look at the whole scene again (R)", () => this.home()),
        button("⤓", "Save a picture (S)", () => this.savePicture()),
        button("◐", "Dark or light (D)", () => this.changeTheme()),
        button("?", "Keyboard help (?)", () => this.help.showModal())));
  }

  private makeView(): View3D | undefined {
    try {
      const view = new View3D(this.stage, this.source, this.ghost, extentOf(this.source.header, this.source.frames), runColor(1));
      view.onChange = () => (this.isDirty = true);
      let down = [0, 0];
      view.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
      view.canvas.addEventListener("click", (event) => {
        if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
        this.select(view.pick(event.offsetX, event.offsetY));
      });
      return view;
    } catch {
      this.stage.append(el("p", { class: "hint", text: "This browser gives no WebGL 2, so the scene cannot be drawn; the plots, the numbers and the audit are here." }));
      return undefined;
    }
  }

  private home(): void {
    this.view?.startFollowing(-1);
    this.view?.fit();
    this.invalidate();
  }

  private frame(now: number): void {
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
    this.view?.draw(time, this.shown, this.selected, this.event, this.flagged);
    this.transport.update();
    if (isPlaying && now - this.lastNumbers < numbersPause) return;
    this.lastNumbers = now;
    this.plots.setTime(time);
    if (this.view) this.panel.showBody(this.selected, this.view.motion, this.selected < 0 ? [] : this.source.contactsAt(time), this.view.followed);
  }

  private invalidate(): void {
    this.isDirty = true;
    this.lastNumbers = 0;
  }

  private setEvent(event: MotionEvent | undefined): void {
    if (this.event === event) return;
    this.event = event;
    this.panel.showEvent(event);
  }

  private resize(): void {
    this.view?.resize(Math.max(1, this.stage.clientWidth), Math.max(1, this.stage.clientHeight));
    this.invalidate();
  }

  private changeTheme(): void {
    const isDark = getComputedStyle(this.element).getPropertyValue("--is-dark").trim() === "1";
    document.documentElement.dataset.theme = isDark ? "light" : "dark";
    this.applyTheme();
  }

  private applyTheme(): void {
    const style = getComputedStyle(this.element);
    const color = (name: string) => style.getPropertyValue(name).trim();
    this.view?.setTheme(color("--stage"), color("--ground"), color("--ground-line"));
    this.plots.redraw();
    this.transport.drawTicks();
    this.invalidate();
  }

  /** The scene as a PNG file, in the folder for downloads. */
  private savePicture(): void {
    if (!this.view) return;
    this.view.draw(this.playback.time, this.shown, this.selected, this.event, this.flagged);
    this.view.canvas.toBlob((blob) => {
      if (!blob) return;
      const link = el("a", { href: URL.createObjectURL(blob), download: `${this.source.header.scene}-${format.time(this.playback.time, 1e-4)}s.png` });
      link.click();
      URL.revokeObjectURL(link.href);
    });
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

  private press(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (target.matches("input[type=search], select")) {
      if (event.key === "Escape") target.blur();
      return;
    }
    const many = event.shiftKey ? 10 : 1;
    const toggles: Record<string, keyof Shown> = { c: "contacts", v: "velocities", x: "frames", i: "inertia", j: "joints", t: "trails", p: "penetration", g: "ghost", h: "shadows" };
    const acts: Record<string, () => void> = {
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
      f: () => this.selected >= 0 && this.follow(this.selected),
      r: () => this.home(),
      s: () => this.savePicture(),
      d: () => this.changeTheme(),
      P: () => this.showDeepest(),
      "/": () => this.panel.search.focus(),
      "?": () => (this.help.open ? this.help.close() : this.help.showModal()),
      Escape: () => (this.help.open ? this.help.close() : this.select(-1)),
    };
    const toggle = toggles[event.key];
    const act = toggle ? () => this.flip(toggle) : acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
    this.invalidate();
  }

  private flip(name: keyof Shown): void {
    (this.shown[name] as boolean) = !this.shown[name];
    this.panel.updateShown();
  }
}

function helpDialog(): HTMLDialogElement {
  const dialog = el("dialog", { class: "help", "aria-label": "Keyboard help" },
    el("h2", { text: "Keys" }),
    el("table", {}, ...keyHelp.map(([keys, text]) => el("tr", {}, el("th", { scope: "row" }, ...keys.split(" ").map((key) => el("kbd", { text: key }))), el("td", { text })))),
    el("p", { text: "Mouse: drag turns, right drag shifts, wheel comes closer, a click chooses a body. Time line: a click on a tick goes to that impact." }),
    button("Close", "Close", () => dialog.close()));
  return dialog;
}
