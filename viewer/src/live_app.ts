import { button, el } from "./dom";
import { extentOf } from "./extent";
import * as format from "./format";
import { withPlanes } from "./live_extent";
import { LiveControl } from "./live_control";
import { LiveLink } from "./live_link";
import type { LiveCommand, LiveFile, LiveStatus } from "./live_message";
import { LivePlot } from "./live_plot";
import { LiveSource } from "./live_source";
import { LiveTools, type Tool } from "./live_tools";
import { shownAtFirst, vectorAt, type Shown } from "./marks";
import { Panel } from "./panel";
import { speeds } from "./playback";
import type { Run } from "./run";
import { View3D } from "./view3d";

/** The numbers beside the scene and the plot change at most this often [ms]. */
const numbersPause = 100;

/** The page of a simulation that goes on while it is looked at. */
export class LiveApp {
  readonly element: HTMLElement;
  readonly source: LiveSource;
  readonly view: View3D | undefined;
  readonly tools: LiveTools | undefined;
  status: LiveStatus | undefined;
  selected = -1;
  private readonly link: LiveLink;
  private readonly shown: Shown = { ...shownAtFirst };
  private readonly control: LiveControl;
  private readonly panel: Panel;
  private readonly plot: LivePlot;
  private readonly stage = el("div", { class: "stage" });
  private readonly lost = el("p", { class: "problem", role: "alert", text: "No connection to the simulation: it was ended, or another page took its place." });
  private readonly stopped = el("p", { class: "problem", role: "alert" });
  private readonly runButton = button("▶", "Run or pause (space)", () => this.toggle());
  private readonly speed: HTMLSelectElement;
  private readonly clock = el("span", { class: "clock" });
  private isDirty = true;
  private lastNumbers = 0;

  constructor(run: Run, private readonly generation: number) {
    this.source = new LiveSource(run);
    this.source.onFrame = () => this.invalidate();
    this.link = new LiveLink({
      status: (status) => this.showStatus(status),
      frame: (frame) => frame.generation === this.generation && this.source.take(frame),
      file: (file) => keep(file),
      errors: (messages) => this.control.showErrors(messages),
      connected: (isConnected) => (this.lost.hidden = isConnected),
    });
    this.control = new LiveControl(run.header, (command) => this.send(command));
    this.panel = new Panel(this.source, this.shown, false, {
      select: (body) => this.select(body),
      follow: (body) => this.follow(body),
      changed: () => this.invalidate(),
      showDeepest: () => {},
    }, this.control.element);
    this.plot = new LivePlot(this.source);
    this.runButton.id = "run";
    this.speed = el("select", { title: "Simulated seconds a second", "aria-label": "Speed", onchange: () => this.send({ do: "speed", value: Number(this.speed.value) }) },
      ...[...speeds, 100, 1000].map((value) => el("option", { value }, format.speed(value))));
    this.view = this.makeView(run);
    if (this.view) this.tools = new LiveTools(this.stage, this.view, run.header, (command) => this.send(command));
    this.stopped.hidden = true;
    this.element = el("div", { class: "app live" }, this.head(), this.lost, this.stopped,
      el("div", { class: "middle" }, this.stage, this.panel.element), this.bar(), this.plot.element);
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

  send(command: LiveCommand): void {
    this.control.showErrors(this.link.send(command) ? [] : ["The simulation cannot be reached; nothing was changed."]);
  }

  toggle(): void {
    this.send({ do: this.status?.running ? "pause" : "run" });
  }

  select(body: number): void {
    this.selected = body;
    if (body < 0) this.view?.startFollowing(-1);
    this.invalidate();
  }

  follow(body: number): void {
    this.view?.startFollowing(this.view.followed === body ? -1 : body);
    this.invalidate();
  }

  /** Where a body's centre of mass is drawn now, in the world [m]. */
  positionOf(body: number): number[] {
    if (!this.view) return [];
    return vectorAt(this.view.motion.position, body).map((x, c) => x + this.source.header.origin[c]);
  }

  private showStatus(status: LiveStatus): void {
    // Another scene has other bodies: the page is made anew.
    if (status.generation !== this.generation) return window.location.reload();
    this.status = status;
    this.control.update(status);
    this.runButton.textContent = status.running ? "❚❚" : "▶";
    if (document.activeElement !== this.speed) this.speed.value = String(status.speed);
    this.stopped.hidden = status.stopped === "";
    this.stopped.textContent = `${status.stopped}. Change something or reset.`;
    this.invalidate();
  }

  private head(): HTMLElement {
    const { header } = this.source;
    return el("header", {},
      el("h1", { text: header.scene }),
      el("span", { class: "about", text: `live · ${header.bodies.length} ${header.bodies.length === 1 ? "body" : "bodies"}` }),
      el("span", { class: "tools" },
        button("⌂", "Look at the whole scene again (R)", () => this.home()),
        button("◐", "Dark or light (D)", () => this.changeTheme())));
  }

  private bar(): HTMLElement {
    const hit = el("input", { type: "range", min: 0.1, max: 20, step: 0.1, value: 2, title: "Speed that a hit gives [m/s]", "aria-label": "Speed that a hit gives", oninput: () => this.tools && (this.tools.hitSpeed = Number(hit.value)) });
    const tools = new Map<Tool, HTMLButtonElement>();
    const choose = (tool: Tool) => {
      if (this.tools) this.tools.tool = tool;
      for (const [name, own] of tools) {
        own.classList.toggle("on", name === tool);
        own.setAttribute("aria-pressed", String(name === tool));
      }
    };
    tools.set("turn", button("Turn", "Drag turns the camera", () => choose("turn")));
    tools.set("pull", button("Pull", "Drag pulls a body (Shift and drag)", () => choose("pull")));
    tools.set("hit", button("Hit", "A click hits a body along the line of sight (Alt and click)", () => choose("hit")));
    choose("turn");
    return el("div", { class: "transport" }, el("div", { class: "buttons" },
      this.runButton,
      button("›", "One output interval on (→)", () => this.send({ do: "step" })),
      button("|◂", "Back to t = 0 (Home)", () => this.send({ do: "reset" })),
      this.speed, ...tools.values(), hit,
      button("Save state", "Keep a checkpoint for rigor run --resume", () => this.send({ do: "save" })),
      button("Export page", "Keep what was recorded since t = 0 as a page of its own", () => this.send({ do: "export" })),
      this.clock));
  }

  private makeView(run: Run): View3D | undefined {
    try {
      const view = new View3D(this.stage, this.source, undefined, withPlanes(run.header, extentOf(run.header, run.frames)));
      view.onChange = () => (this.isDirty = true);
      let down = [0, 0];
      view.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
      view.canvas.addEventListener("click", (event) => {
        if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
        this.select(view.pick(event.offsetX, event.offsetY));
      });
      return view;
    } catch {
      this.stage.append(el("p", { class: "hint", text: "This browser gives no WebGL 2, so the scene cannot be drawn; the numbers and the controls are here." }));
      return undefined;
    }
  }

  private frame(now: number): void {
    requestAnimationFrame((next) => this.frame(next));
    if (!this.isDirty) return;
    this.isDirty = false;
    this.view?.draw(this.source.time, this.shown, this.selected, undefined, []);
    this.tools?.update();
    if (now - this.lastNumbers < numbersPause) {
      this.isDirty = true;
      return;
    }
    this.lastNumbers = now;
    const rate = this.status?.running ? ` · ${format.number(this.status.rate, 2)}×` : "";
    this.clock.textContent = `${format.time(this.source.time, this.source.header.output_interval)} s${rate}`;
    this.plot.update();
    if (this.view) this.panel.showBody(this.selected, this.view.motion, this.selected < 0 ? [] : this.source.contactsAt(), this.view.followed);
  }

  private invalidate(): void {
    this.isDirty = true;
  }

  private home(): void {
    this.view?.startFollowing(-1);
    this.view?.fit();
    this.invalidate();
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
    this.plot.redraw();
    this.invalidate();
  }

  private press(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches("input, select")) return;
    const toggles: Record<string, keyof Shown> = { c: "contacts", v: "velocities", x: "frames", i: "inertia", j: "joints", p: "penetration", h: "shadows" };
    const acts: Record<string, () => void> = {
      " ": () => this.toggle(),
      ArrowRight: () => this.send({ do: "step" }),
      Home: () => this.send({ do: "reset" }),
      f: () => this.selected >= 0 && this.follow(this.selected),
      r: () => this.home(),
      d: () => this.changeTheme(),
      "/": () => this.panel.search.focus(),
      Escape: () => this.select(-1),
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

/** Gives a file of the simulation to the folder for downloads. */
function keep({ name, bytes }: LiveFile): void {
  const link = el("a", { href: URL.createObjectURL(new Blob([bytes])), download: name });
  link.click();
  URL.revokeObjectURL(link.href);
}
