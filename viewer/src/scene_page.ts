import type { ComparePlots } from "./compare_plots";
import { button, el } from "./dom";
import type { Extent } from "./extent";
import { Film } from "./film";
import * as format from "./format";
import { shownAtFirst, suit, vectorAt, type Shown } from "./marks";
import type { Panel } from "./panel";
import type { Plots } from "./plots";
import type { MotionEvent } from "./run";
import { runColor } from "./run_names";
import type { FrameSource } from "./source";
import { View3D } from "./view3d";

const toggles: Record<string, keyof Shown> = { c: "contacts", v: "velocities", x: "frames", i: "inertia", j: "joints", t: "trails", p: "penetration", g: "ghost", h: "shadows", m: "heat" };

/** What the page of a stored run and that of a live one share: the scene with its camera, the chosen body and event, keys, dark and light. */
export abstract class ScenePage<Source extends FrameSource> {
  abstract readonly element: HTMLElement;
  abstract readonly plots: Plots | ComparePlots;
  /** None where the browser has no WebGL: then all but the scene works. */
  readonly view: View3D | undefined;
  selected = -1;
  protected abstract readonly panel: Panel;
  protected readonly shown: Shown = { ...shownAtFirst, chosen: new Set() };
  protected readonly stage = el("div", { class: "stage" });
  protected readonly help: HTMLDialogElement;
  protected event: MotionEvent | undefined;
  /** The bodies of the deepest penetration, while it is looked at. */
  protected flagged: number[] = [];
  protected isDirty = true;
  protected lastNumbers = 0;

  /** The run that is looked at, and the one that is its ghost. */
  constructor(public source: Source, public ghost: Source | undefined, extent: Extent, keyHelp: [string, string][], ghostColor = runColor(1)) {
    this.view = this.makeView(extent, ghostColor);
    this.help = helpDialog(keyHelp);
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

  /** Where a body's centre of mass is drawn now, in the world [m]. */
  positionOf(body: number): number[] {
    if (!this.view) return [];
    return vectorAt(this.view.motion.position, body).map((x, c) => x + this.source.header.origin[c]);
  }

  /** Time of the moment that is drawn [s]. */
  protected abstract get time(): number;
  /** Called for each picture that the browser makes. */
  protected abstract frame(now: number): void;
  protected abstract redrawTicks(): void;
  /** What keys do besides those that both kinds of page have. */
  protected abstract keys(event: KeyboardEvent): Record<string, () => void>;

  protected drawScene(): void {
    if (suit(this.shown, this.source)) this.panel.updateShown();
    this.view?.draw(this.time, this.shown, this.selected, this.event, this.flagged);
    this.panel.showHeat(this.shown.heat ? this.view?.hottest : undefined);
  }

  protected invalidate(): void {
    this.isDirty = true;
  }

  protected setEvent(event: MotionEvent | undefined): void {
    if (this.event === event) return;
    this.event = event;
    this.panel.showEvent(event);
  }

  protected resize(): void {
    this.view?.resize(Math.max(1, this.stage.clientWidth), Math.max(1, this.stage.clientHeight));
    this.invalidate();
  }

  /** Buttons at the right end of the head. */
  protected tools(): HTMLElement {
    return el("span", { class: "tools" },
      button("⌂", "Look at the whole scene again (R)", () => this.home()),
      button("⤓", "Save a picture (S)", () => this.savePicture()),
      this.filmButton(),
      button("◐", "Dark or light (D)", () => this.changeTheme()),
      button("?", "Keyboard help (?)", () => this.help.showModal()));
  }

  private makeView(extent: Extent, ghostColor: string): View3D | undefined {
    try {
      const view = new View3D(this.stage, this.source, this.ghost, extent, ghostColor);
      view.onChange = () => (this.isDirty = true);
      let down = [0, 0];
      view.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
      view.canvas.addEventListener("click", (event) => {
        if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
        this.select(view.pick(event.offsetX, event.offsetY));
      });
      return view;
    } catch {
      this.stage.append(el("p", { class: "hint", text: "This browser gives no WebGL 2, so the scene cannot be drawn; all the rest of the page is here." }));
      return undefined;
    }
  }

  private home(): void {
    this.view?.startFollowing(-1);
    this.view?.fit();
    this.invalidate();
  }

  /** The first press begins a film of the scene, the second one ends it. */
  private filmButton(): HTMLElement | undefined {
    if (!this.view || !Film.isPossible) return undefined;
    const own = button("●", "Record a film of the scene", () => (film.isRunning ? film.end() : film.begin(), show()));
    const film = new Film(this.view.canvas, (blob, suffix) => {
      keep(`${this.source.header.scene}.${suffix}`, blob);
      show();
    });
    const show = () => {
      own.classList.toggle("on", film.isRunning);
      own.setAttribute("aria-pressed", String(film.isRunning));
      own.textContent = film.isRunning ? "■" : "●";
      this.invalidate();
    };
    return own;
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
    this.redrawTicks();
    this.invalidate();
  }

  /** The scene as a PNG file, in the folder for downloads. */
  private savePicture(): void {
    this.drawScene();
    this.view?.canvas.toBlob((blob) => blob && keep(`${this.source.header.scene}-${format.time(this.time, 1e-4)}s.png`, blob));
  }

  private press(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    // What the keyboard has gone to takes the keys that press it.
    if ((event.key === " " || event.key === "Enter") && target.matches("button:focus-visible, summary, input, a")) return;
    if (target.matches("input:not([type=checkbox]), select")) {
      if (event.key === "Escape") target.blur();
      return;
    }
    const acts: Record<string, () => void> = {
      f: () => this.selected >= 0 && this.follow(this.selected),
      r: () => this.home(),
      s: () => this.savePicture(),
      d: () => this.changeTheme(),
      "/": () => this.panel.search.focus(),
      "?": () => (this.help.open ? this.help.close() : this.help.showModal()),
      Escape: () => (this.help.open ? this.help.close() : this.select(-1)),
      ...this.keys(event),
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
    this.shown.chosen.add(name);
    this.panel.updateShown();
  }
}

/** Gives a file to the folder for downloads. */
export function keep(name: string, content: Blob): void {
  const link = el("a", { href: URL.createObjectURL(content), download: name });
  link.click();
  URL.revokeObjectURL(link.href);
}

function helpDialog(keyHelp: [string, string][]): HTMLDialogElement {
  const dialog = el("dialog", { class: "help", "aria-label": "Keyboard help" },
    el("h2", { text: "Keys" }),
    el("table", {}, ...keyHelp.map(([keys, text]) => el("tr", {}, el("th", { scope: "row" }, ...keys.split(" ").map((key) => el("kbd", { text: key }))), el("td", { text })))),
    el("p", { text: "Mouse: drag turns, right drag shifts, wheel comes closer, a click chooses a body. Time line: a click on a tick shows that impact." }),
    button("Close", "Close", () => dialog.close()));
  return dialog;
}
