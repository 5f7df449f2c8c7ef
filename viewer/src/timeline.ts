import { el } from "./dom";
import * as format from "./format";
import type { MotionEvent } from "./run";
import { lastAtMost, nearest } from "./search";

export interface TimeLineActions {
  seek(time: number): void;
  showEvent(index: number): void;
}

/** Nearer than this to a tick a click means the tick [CSS pixels]. */
const tickReach = 5;

/** The time from its beginning to its end with a tick for each event, and a handle where the page stands. */
export class TimeLine {
  readonly element: HTMLElement;
  private readonly ticks = el("canvas");
  private readonly handle = el("div", { class: "handle" });
  private events: MotionEvent[] = [];
  private impactTimes = new Float64Array();
  private impacts: number[] = [];

  /** The range may change; resolution: what times are rounded to in words [s]. */
  constructor(private readonly range: { readonly begin: number; readonly end: number }, events: MotionEvent[], private readonly resolution: number, private readonly actions: TimeLineActions) {
    this.element = el("div", {
      class: "line", id: "scrubber", role: "slider", tabindex: 0, "aria-label": "Time", "aria-valuemin": range.begin, "aria-valuemax": range.end,
    }, this.ticks, this.handle);
    this.element.addEventListener("pointerdown", (event) => this.press(event));
    this.element.addEventListener("pointermove", (event) => {
      if (this.element.hasPointerCapture(event.pointerId)) actions.seek(this.timeAt(event.clientX));
      else this.element.title = this.hint(event.clientX);
    });
    this.setEvents(events);
    new ResizeObserver(() => this.drawTicks()).observe(this.element);
  }

  setEvents(events: MotionEvent[]): void {
    this.events = events;
    this.impacts = events.flatMap((event, i) => (event.kind === "impact" ? [i] : []));
    this.impactTimes = Float64Array.from(this.impacts, (i) => events[i].time);
    this.element.setAttribute("aria-valuemax", String(this.range.end));
    this.drawTicks();
  }

  get hasImpacts(): boolean {
    return this.impacts.length > 0;
  }

  /** Puts the handle to a time; finer: what that is rounded to in words [s]. */
  update(time: number, finer = this.resolution): void {
    this.handle.style.left = `${100 * this.placeOf(time)}%`;
    this.element.setAttribute("aria-valuenow", time.toFixed(6));
    this.element.setAttribute("aria-valuetext", `${format.time(time, finer)} seconds`);
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
    const width = this.element.clientWidth;
    const height = this.element.clientHeight;
    if (width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    this.ticks.width = width * ratio;
    this.ticks.height = height * ratio;
    const context = this.ticks.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    const style = getComputedStyle(this.element);
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
    const { begin, end } = this.range;
    return end > begin ? (time - begin) / (end - begin) : 0;
  }

  private timeAt(clientX: number): number {
    const box = this.element.getBoundingClientRect();
    const part = Math.min(1, Math.max(0, (clientX - box.left) / box.width));
    return this.range.begin + part * (this.range.end - this.range.begin);
  }

  /** The impact whose tick is under the pointer, or undefined. */
  private tickAt(clientX: number): number | undefined {
    const i = nearest(this.impactTimes, this.timeAt(clientX));
    if (i < 0) return undefined;
    const box = this.element.getBoundingClientRect();
    const away = Math.abs(box.left + this.placeOf(this.impactTimes[i]) * box.width - clientX);
    return away <= tickReach ? this.impacts[i] : undefined;
  }

  private hint(clientX: number): string {
    const tick = this.tickAt(clientX);
    return tick === undefined ? `${format.time(this.timeAt(clientX), this.resolution)} s` : `impact at ${format.number(this.events[tick].time, 8)} s`;
  }

  private press(event: PointerEvent): void {
    this.element.focus();
    const tick = this.tickAt(event.clientX);
    if (tick !== undefined) {
      this.actions.showEvent(tick);
      return;
    }
    this.element.setPointerCapture(event.pointerId);
    this.actions.seek(this.timeAt(event.clientX));
  }
}
