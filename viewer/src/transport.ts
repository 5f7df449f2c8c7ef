import { button, el } from "./dom";
import * as format from "./format";
import { speeds, type Playback } from "./playback";
import { lastAtMost, nearest } from "./search";
import type { MotionEvent } from "./run";

export interface TransportActions {
  toggle(): void;
  step(frames: number): void;
  seek(time: number): void;
  showEvent(index: number): void;
  nextImpact(direction: 1 | -1): void;
}

/** Nearer than this to a tick a click means the tick [CSS pixels]. */
const tickReach = 5;

/** Play, step, speed, and the time line with a tick for each event. */
export class Transport {
  readonly element: HTMLElement;
  private readonly play: HTMLButtonElement;
  private readonly loop: HTMLButtonElement;
  private readonly speed: HTMLSelectElement;
  private readonly clock: HTMLElement;
  private readonly line: HTMLElement;
  private readonly ticks: HTMLCanvasElement;
  private readonly handle: HTMLElement;
  private readonly impactButtons: HTMLButtonElement[];
  private events: MotionEvent[] = [];
  private impactTimes = new Float64Array();
  private impacts: number[] = [];

  constructor(private readonly playback: Playback, events: MotionEvent[], private readonly resolution: number, private readonly actions: TransportActions) {
    this.play = button("▶", "Play or pause (space)", () => actions.toggle());
    this.play.id = "play";
    this.loop = button("⟳", "Loop (L)", () => {
      playback.isLooping = !playback.isLooping;
      this.update();
    });
    this.speed = el("select", { title: "Speed (− and +)", "aria-label": "Speed", onchange: () => (playback.speed = Number(this.speed.value)) },
      ...speeds.map((value) => el("option", { value }, format.speed(value))));
    this.clock = el("span", { class: "clock" });
    this.ticks = el("canvas");
    this.handle = el("div", { class: "handle" });
    this.line = el("div", {
      class: "line", id: "scrubber", role: "slider", tabindex: 0, "aria-label": "Time", "aria-valuemin": playback.begin, "aria-valuemax": playback.end,
    }, this.ticks, this.handle);
    this.line.addEventListener("pointerdown", (event) => this.press(event));
    this.line.addEventListener("pointermove", (event) => {
      if (this.line.hasPointerCapture(event.pointerId)) actions.seek(this.timeAt(event.clientX));
      else this.line.title = this.hint(event.clientX);
    });
    this.impactButtons = [button("⇤ impact", "Previous impact ([)", () => actions.nextImpact(-1)), button("impact ⇥", "Next impact (])", () => actions.nextImpact(1))];
    this.element = el("div", { class: "transport" },
      el("div", { class: "buttons" },
        button("|◂", "First frame (Home)", () => actions.seek(playback.begin)),
        button("‹", "One frame back (←)", () => actions.step(-1)),
        this.play,
        button("›", "One frame on (→)", () => actions.step(1)),
        button("▸|", "Last frame (End)", () => actions.seek(playback.end)),
        this.loop, this.speed, ...this.impactButtons, this.clock),
      this.line);
    this.setEvents(events);
    new ResizeObserver(() => this.drawTicks()).observe(this.line);
  }

  /** From now on the ticks are those of these events. */
  setEvents(events: MotionEvent[]): void {
    this.events = events;
    this.impacts = events.flatMap((event, i) => (event.kind === "impact" ? [i] : []));
    this.impactTimes = Float64Array.from(this.impacts, (i) => events[i].time);
    for (const own of this.impactButtons) own.hidden = this.impacts.length === 0;
    this.drawTicks();
  }

  update(): void {
    const { playback } = this;
    const part = playback.end > playback.begin ? (playback.time - playback.begin) / (playback.end - playback.begin) : 0;
    this.handle.style.left = `${100 * part}%`;
    this.play.textContent = playback.isPlaying ? "❚❚" : "▶";
    this.loop.classList.toggle("on", playback.isLooping);
    this.loop.setAttribute("aria-pressed", String(playback.isLooping));
    this.speed.value = String(playback.speed);
    const finer = this.resolution * Math.min(1, playback.speed);
    this.clock.textContent = `${format.time(playback.time, finer)} / ${format.number(playback.end)} s`;
    this.line.setAttribute("aria-valuenow", playback.time.toFixed(6));
    this.line.setAttribute("aria-valuetext", `${format.time(playback.time, finer)} seconds`);
  }

  /** Index of the impact before (-1) or after (1) a time, or undefined. */
  impactFrom(time: number, direction: 1 | -1): number | undefined {
    const tolerance = 1e-9 * Math.max(1, Math.abs(time));
    const times = this.impactTimes;
    if (times.length === 0) return undefined;
    let i = lastAtMost(times, time + tolerance);
    if (direction === 1) i = times[i] > time + tolerance ? i : i + 1;
    else i = lastAtMost(times, time - tolerance);
    return i < times.length && (direction === 1 || times[i] < time - tolerance) ? this.impacts[i] : undefined;
  }

  drawTicks(): void {
    const width = this.line.clientWidth;
    const height = this.line.clientHeight;
    if (width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    this.ticks.width = width * ratio;
    this.ticks.height = height * ratio;
    const context = this.ticks.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    const style = getComputedStyle(this.line);
    const colors = { impact: style.getPropertyValue("--impact"), other: style.getPropertyValue("--quiet") };
    // One tick a pixel and kind, however many events fall there.
    const drawn = new Set<string>();
    for (const event of this.events) {
      const x = Math.round(this.placeOf(event.time) * width);
      const isImpact = event.kind === "impact";
      const name = `${x} ${isImpact}`;
      if (drawn.has(name)) continue;
      drawn.add(name);
      context.fillStyle = isImpact ? colors.impact : colors.other;
      context.fillRect(x - 0.5, isImpact ? 4 : height - 8, 1, isImpact ? height - 14 : 6);
    }
  }

  private placeOf(time: number): number {
    const { begin, end } = this.playback;
    return end > begin ? (time - begin) / (end - begin) : 0;
  }

  private timeAt(clientX: number): number {
    const box = this.line.getBoundingClientRect();
    const part = Math.min(1, Math.max(0, (clientX - box.left) / box.width));
    return this.playback.begin + part * (this.playback.end - this.playback.begin);
  }

  /** The impact whose tick is under the pointer, or undefined. */
  private tickAt(clientX: number): number | undefined {
    const i = nearest(this.impactTimes, this.timeAt(clientX));
    if (i < 0) return undefined;
    const box = this.line.getBoundingClientRect();
    const away = Math.abs(box.left + this.placeOf(this.impactTimes[i]) * box.width - clientX);
    return away <= tickReach ? this.impacts[i] : undefined;
  }

  private hint(clientX: number): string {
    const tick = this.tickAt(clientX);
    return tick === undefined ? `${format.time(this.timeAt(clientX), this.resolution)} s` : `impact at ${format.number(this.events[tick].time, 8)} s`;
  }

  private press(event: PointerEvent): void {
    this.line.focus();
    const tick = this.tickAt(event.clientX);
    if (tick !== undefined) {
      this.actions.showEvent(tick);
      return;
    }
    this.line.setPointerCapture(event.pointerId);
    this.actions.seek(this.timeAt(event.clientX));
  }
}
