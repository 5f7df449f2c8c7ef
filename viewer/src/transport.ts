import { button, el } from "./dom";
import * as format from "./format";
import { speeds, type Playback } from "./playback";
import type { MotionEvent } from "./run";
import { TimeLine, type TimeLineActions } from "./timeline";

export interface TransportActions extends TimeLineActions {
  toggle(): void;
  step(frames: number): void;
  nextImpact(direction: 1 | -1): void;
}

/** Play, step, speed, and the time line with a tick for each event. */
export class Transport {
  readonly element: HTMLElement;
  readonly line: TimeLine;
  private readonly play: HTMLButtonElement;
  private readonly loop: HTMLButtonElement;
  private readonly speed: HTMLSelectElement;
  private readonly clock: HTMLElement;
  private readonly impactButtons: HTMLButtonElement[];

  constructor(private readonly playback: Playback, events: MotionEvent[], private readonly resolution: number, actions: TransportActions) {
    this.line = new TimeLine(playback, events, resolution, actions);
    this.play = button("▶", "Play or pause (space)", () => actions.toggle());
    this.play.id = "play";
    this.loop = button("⟳", "Loop (L)", () => {
      playback.isLooping = !playback.isLooping;
      this.update();
    });
    this.speed = el("select", { title: "Speed (− and +)", "aria-label": "Speed", onchange: () => (playback.speed = Number(this.speed.value)) },
      ...speeds.map((value) => el("option", { value }, format.speed(value))));
    this.clock = el("span", { class: "clock" });
    this.impactButtons = [button("⇤ impact", "Previous impact ([)", () => actions.nextImpact(-1)), button("impact ⇥", "Next impact (])", () => actions.nextImpact(1))];
    this.element = el("div", { class: "transport" },
      el("div", { class: "buttons" },
        button("|◂", "First frame (Home)", () => actions.seek(playback.begin)),
        button("‹", "One frame back (←)", () => actions.step(-1)),
        this.play,
        button("›", "One frame on (→)", () => actions.step(1)),
        button("▸|", "Last frame (End)", () => actions.seek(playback.end)),
        this.loop, this.speed, ...this.impactButtons, this.clock),
      this.line.element);
    this.setEvents(events);
  }

  /** From now on the ticks are those of these events. */
  setEvents(events: MotionEvent[]): void {
    this.line.setEvents(events);
    for (const own of this.impactButtons) own.hidden = !this.line.hasImpacts;
  }

  update(): void {
    const { playback } = this;
    this.play.textContent = playback.isPlaying ? "❚❚" : "▶";
    this.loop.classList.toggle("on", playback.isLooping);
    this.loop.setAttribute("aria-pressed", String(playback.isLooping));
    this.speed.value = String(playback.speed);
    const finer = this.resolution * Math.min(1, playback.speed);
    this.clock.textContent = `${format.time(playback.time, finer)} / ${format.number(playback.end)} s`;
    this.line.update(playback.time, finer);
  }
}
