import { button, el, shown } from "./dom";
import { extentOf } from "./extent";
import * as format from "./format";
import { liveKeyHelp } from "./keys";
import { withPlanes } from "./live_extent";
import { LiveControl } from "./live_control";
import { LiveLink } from "./live_link";
import type { LiveCommand, LiveStatus } from "./live_message";
import { LiveSource } from "./live_source";
import { LiveTools, type Tool } from "./live_tools";
import { Panel } from "./panel";
import { speeds } from "./playback";
import { Plots } from "./plots";
import type { Run } from "./run";
import { keep, ScenePage } from "./scene_page";
import { TimeLine } from "./timeline";

/** The numbers beside the scene change at most this often [ms]. */
const numbersPause = 100;

/** The page of a simulation that goes on while it is looked at. */
export class LiveApp extends ScenePage<LiveSource> {
  readonly element: HTMLElement;
  readonly plots: Plots;
  readonly line: TimeLine;
  readonly tools3d: LiveTools | undefined;
  status: LiveStatus | undefined;
  protected readonly panel: Panel;
  private readonly link: LiveLink;
  private readonly control: LiveControl;
  private readonly lost = el("p", { class: "problem", role: "alert", text: "No connection to the simulation: it was ended, or another page took its place." });
  private readonly stopped = el("p", { class: "problem", role: "alert" });
  private readonly runButton = button("▶", "Run or pause (space)", () => this.toggle());
  private readonly backButton = button("‹", "One output interval back (←)", () => this.send({ do: "back" }));
  private readonly speed: HTMLSelectElement;
  private readonly clock = el("span", { class: "clock" });
  private readonly range = { begin: 0, end: 0 };

  constructor(run: Run, private readonly generation: number) {
    super(new LiveSource(run), undefined, withPlanes(run.header, extentOf(run.header, run.frames, run.meshes)), liveKeyHelp);
    const { source } = this;
    this.range.end = source.time;
    this.control = new LiveControl(run.header, (command) => this.send(command));
    this.panel = new Panel(source, this.shown, false, {
      select: (body) => this.select(body),
      follow: (body) => this.follow(body),
      changed: () => this.invalidate(),
      showDeepest: () => {},
    }, this.control.element);
    this.plots = new Plots(source, () => this.showEvent(undefined));
    this.line = new TimeLine(this.range, source.events, run.header.output_interval, {
      seek: () => this.showEvent(undefined),
      showEvent: (index) => this.showEvent(index),
    });
    this.runButton.id = "run";
    this.speed = el("select", { title: "Simulated seconds a second", "aria-label": "Speed", onchange: () => this.send({ do: "speed", value: Number(this.speed.value) }) },
      ...[...speeds, 100, 1000].map((value) => el("option", { value }, format.speed(value))));
    if (this.view) this.tools3d = new LiveTools(this.stage, this.view, source, (command) => this.send(command), (body) => this.select(body));
    this.stopped.hidden = true;
    this.element = el("main", { class: "app live" }, this.head(), this.lost, this.stopped,
      el("div", { class: "middle" }, this.stage, this.panel.element), this.bar(), this.plots.element, this.help);
    source.onFrame = () => this.invalidate();
    source.onHistory = () => this.takeHistory();
    this.link = new LiveLink(run.header.origin, {
      status: (status) => this.showStatus(status),
      frame: (frame) => frame.generation === this.generation && source.take(frame),
      history: (history) => history.generation === this.generation && source.remember(history),
      file: ({ name, bytes }) => keep(name, new Blob([bytes])),
      errors: (messages) => this.control.showErrors(messages),
      connected: (isConnected) => (this.lost.hidden = isConnected),
    });
  }

  send(command: LiveCommand): void {
    this.control.showErrors(this.link.send(command) ? [] : ["The simulation cannot be reached; nothing was changed."]);
  }

  toggle(): void {
    this.send({ do: this.status?.running ? "pause" : "run" });
  }

  /** Shows where an event was and what it did; undefined: none. The simulation goes on. */
  showEvent(index: number | undefined): void {
    this.setEvent(index === undefined ? undefined : this.source.events[index]);
    this.invalidate();
  }

  protected get time(): number {
    return this.source.time;
  }

  protected redrawTicks(): void {
    this.line.drawTicks();
  }

  private nextImpact(direction: 1 | -1): void {
    const index = this.line.impactFrom(this.event?.time ?? this.source.time, direction);
    if (index !== undefined) this.showEvent(index);
  }

  private takeHistory(): void {
    const { times } = this.source;
    // After a reset an event of before is no longer one.
    if (this.event && this.event.time > times[times.length - 1]) this.setEvent(undefined);
    this.range.end = times[times.length - 1] ?? 0;
    this.line.setEvents(this.source.events);
    this.plots.refresh();
    this.invalidate();
  }

  private showStatus(status: LiveStatus): void {
    // Another scene has other bodies: the page is made anew.
    if (status.generation !== this.generation) return window.location.reload();
    this.status = status;
    this.control.update(status);
    this.runButton.textContent = status.running ? "❚❚" : "▶";
    this.backButton.disabled = status.earlier === 0;
    if (document.activeElement !== this.speed) this.speed.value = String(status.speed);
    this.stopped.hidden = status.stopped === "";
    this.stopped.textContent = shown(`${status.stopped}. Change something or reset.`);
    this.invalidate();
  }

  private head(): HTMLElement {
    const { header } = this.source;
    return el("header", {},
      el("h1", { text: header.scene }),
      el("span", { class: "about", text: `live · ${header.bodies.length} ${header.bodies.length === 1 ? "body" : "bodies"}` }),
      this.tools());
  }

  private bar(): HTMLElement {
    const hit = el("input", { type: "range", min: 0.1, max: 20, step: 0.1, value: 2, title: "Speed that a hit gives [m/s]", "aria-label": "Speed that a hit gives", oninput: () => this.tools3d && (this.tools3d.hitSpeed = Number(hit.value)) });
    const tools = new Map<Tool, HTMLButtonElement>();
    const choose = (tool: Tool) => {
      if (this.tools3d) this.tools3d.tool = tool;
      for (const [name, own] of tools) {
        own.classList.toggle("on", name === tool);
        own.setAttribute("aria-pressed", String(name === tool));
      }
    };
    tools.set("grab", button("Grab", "Drag pulls a body, and turns the camera beside bodies", () => choose("grab")));
    tools.set("turn", button("Turn", "Drag turns the camera (with Shift it pulls a body)", () => choose("turn")));
    tools.set("hit", button("Hit", "A click hits a body along the line of sight (Alt and click)", () => choose("hit")));
    choose("grab");
    return el("div", { class: "transport" }, el("div", { class: "buttons" },
      button("|◂", "Back to t = 0 (Home)", () => this.send({ do: "reset" })),
      this.backButton,
      this.runButton,
      button("›", "One output interval on (→)", () => this.send({ do: "step" })),
      this.speed, ...tools.values(), hit,
      button("Save state", "Keep a checkpoint for rigor run --resume", () => this.send({ do: "save" })),
      button("Export page", "Keep what was recorded since t = 0 as a page of its own", () => this.send({ do: "export" })),
      this.clock), this.line.element);
  }

  protected frame(now: number): void {
    requestAnimationFrame((next) => this.frame(next));
    if (!this.isDirty) return;
    this.isDirty = false;
    this.drawScene();
    this.tools3d?.update();
    if (now - this.lastNumbers < numbersPause) {
      this.isDirty = true;
      return;
    }
    this.lastNumbers = now;
    const { source } = this;
    const rate = this.status?.running ? ` · ${format.number(this.status.rate, 2)}×` : "";
    this.clock.textContent = `${format.time(source.time, source.header.output_interval)} s${rate}`;
    const shown = Math.min(this.event?.time ?? source.time, this.range.end);
    this.line.update(shown);
    this.plots.refreshBody();
    this.plots.setTime(shown);
    if (this.view) this.panel.showBody(this.selected, this.view.motion, this.selected < 0 ? [] : source.contactsAt(), this.view.followed);
  }

  protected keys(): Record<string, () => void> {
    return {
      " ": () => this.toggle(),
      ArrowLeft: () => this.send({ do: "back" }),
      ArrowRight: () => this.send({ do: "step" }),
      Home: () => this.send({ do: "reset" }),
      "[": () => this.nextImpact(-1),
      "]": () => this.nextImpact(1),
    };
  }
}
