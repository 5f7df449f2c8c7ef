import { el } from "../dom";

/** Colours of the page, as its style sheet says. */
export interface Colors {
  text: string;
  quiet: string;
  grid: string;
  accent: string;
  box: string;
}

/** A canvas that is as wide as its box, drawn anew when that or the colours change. */
export class Sheet {
  readonly canvas: HTMLCanvasElement;
  width = 0;
  private isDue = false;

  constructor(box: HTMLElement, label: string, private readonly heightFor: (width: number) => number,
              private readonly draw: (context: CanvasRenderingContext2D, colors: Colors) => void) {
    this.canvas = el("canvas", { role: "img", "aria-label": label });
    box.append(this.canvas);
    new ResizeObserver(() => this.redraw()).observe(box);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
  }

  get height(): number {
    return this.heightFor(this.width);
  }

  /** Draws before the next picture, however often it is called. */
  redraw(): void {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      this.paint();
    });
  }

  /** Position of a pointer [CSS pixels]. */
  place(event: PointerEvent): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private paint(): void {
    this.width = Math.floor(this.canvas.parentElement?.clientWidth ?? 0);
    const context = this.canvas.getContext("2d");
    if (!context || this.width === 0) return;
    const scale = devicePixelRatio;
    this.canvas.width = this.width * scale;
    this.canvas.height = this.height * scale;
    this.canvas.style.width = `${this.width}px`;
    this.canvas.style.height = `${this.height}px`;
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.font = "12px system-ui, sans-serif";
    const style = getComputedStyle(document.documentElement);
    const color = (name: string): string => style.getPropertyValue(`--${name}`).trim();
    this.draw(context, { text: color("text"), quiet: color("quiet"), grid: color("grid"), accent: color("accent"), box: color("box") });
  }
}

/** From blue over grey to orange, which the colour-blind tell apart, for a share of 0 to 1. */
export function rampColor(share: number): string {
  const ends = [[0, 114, 178], [150, 150, 150], [213, 94, 0]];
  if (!Number.isFinite(share)) return "rgb(140 140 140)";
  const at = 2 * Math.min(1, Math.max(0, share)), i = Math.min(1, Math.floor(at));
  const mixed = ends[i].map((c, k) => Math.round(c + (at - i) * (ends[i + 1][k] - c)));
  return `rgb(${mixed.join(" ")})`;
}

/** The text, cut off where it would be wider than there is room. */
export function fitted(context: CanvasRenderingContext2D, text: string, room: number): string {
  if (context.measureText(text).width <= room) return text;
  let length = text.length;
  while (length > 1 && context.measureText(`${text.slice(0, length)}…`).width > room) --length;
  return `${text.slice(0, length)}…`;
}
