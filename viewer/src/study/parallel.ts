import { number, shareOf, type Study } from "./data";
import type { Selection } from "./selection";
import { fitted, rampColor, Sheet, type Colors } from "./sheet";

interface Point {
  x: number;
  y: number;
}

const narrow = 640, top = 34, bottom = 24, side = 56, reach = 14;

/**
 * Parallel coordinates: an axis a column, a line a run, in the colour of the main outcome. A drag along an axis keeps the
 * runs between its ends, a click on a line chooses its run. Where there is little room the axes lie.
 *
 * Source: Inselberg, The plane with parallel coordinates, The Visual Computer 1, 1985.
 */
export class ParallelPlot {
  private readonly sheet: Sheet;
  private drag?: { axis: number; begin: number; end: number; at: Point };

  constructor(box: HTMLElement, private readonly study: Study, private readonly selection: Selection) {
    const label = `parallel coordinates of ${study.columns.map(({ name }) => name).join(", ")}`;
    this.sheet = new Sheet(box, label, (width) => (width < narrow ? 58 * study.columns.length - 8 : 320),
                           (context, colors) => this.draw(context, colors));
    const { canvas } = this.sheet;
    canvas.addEventListener("pointerdown", (event) => this.begin(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.end(event));
    canvas.addEventListener("pointercancel", () => (this.drag = undefined));
    selection.listen(() => this.sheet.redraw());
  }

  private get isLying(): boolean {
    return this.sheet.width < narrow;
  }

  /** Where a share of an axis is drawn. */
  private at(axis: number, share: number): Point {
    const { width, height } = this.sheet, last = Math.max(1, this.study.columns.length - 1);
    if (this.isLying) return { x: 20 + share * (width - 40), y: 30 + axis * 58 };
    return { x: side + (axis / last) * (width - 2 * side), y: height - bottom - share * (height - top - bottom) };
  }

  /** The share of an axis beside a place. */
  private shareAt(place: Point): number {
    const { width, height } = this.sheet;
    const share = this.isLying ? (place.x - 20) / (width - 40) : (height - bottom - place.y) / (height - top - bottom);
    return Math.min(1, Math.max(0, share));
  }

  /** The axis within reach of a place, or -1. */
  private axisAt(place: Point): number {
    return this.study.columns.findIndex((_, axis) => {
      const { x, y } = this.at(axis, 0);
      return Math.abs(this.isLying ? place.y - y : place.x - x) < reach;
    });
  }

  private begin(event: PointerEvent): void {
    const place = this.sheet.place(event), share = this.shareAt(place);
    this.sheet.canvas.setPointerCapture(event.pointerId);
    this.drag = { axis: this.axisAt(place), begin: share, end: share, at: place };
  }

  private move(event: PointerEvent): void {
    const place = this.sheet.place(event);
    this.sheet.canvas.style.cursor = this.axisAt(place) >= 0 ? (this.isLying ? "ew-resize" : "ns-resize") : "pointer";
    if (!this.drag || this.drag.axis < 0) return;
    this.drag.end = this.shareAt(place);
    this.sheet.redraw();
  }

  private end(event: PointerEvent): void {
    const drag = this.drag, place = this.sheet.place(event);
    this.drag = undefined;
    if (!drag) return;
    const isClick = Math.hypot(place.x - drag.at.x, place.y - drag.at.y) < 4;
    if (drag.axis >= 0 && !isClick) return this.limit(drag.axis, drag.begin, drag.end);
    // A click on an axis that has a range takes it away.
    if (drag.axis >= 0 && this.selection.ranges.has(drag.axis)) return this.selection.limit(drag.axis);
    const nearest = this.nearest(place);
    if (nearest >= 0) this.selection.choose(nearest);
  }

  private limit(axis: number, a: number, b: number): void {
    const { low, high } = this.study.columns[axis];
    this.selection.limit(axis, [low + Math.min(a, b) * (high - low), low + Math.max(a, b) * (high - low)]);
  }

  /** The run whose line passes nearest to a place, of those within the ranges. */
  private nearest(place: Point): number {
    let best = -1, least = 12;
    for (let run = 0; run < this.study.runs.length; ++run) {
      if (!this.selection.holds(run)) continue;
      for (let axis = 0; axis + 1 < this.study.columns.length; ++axis) {
        const distance = distanceTo(place, this.point(run, axis), this.point(run, axis + 1));
        if (distance < least) (least = distance), (best = run);
      }
    }
    return best;
  }

  private point(run: number, axis: number): Point {
    const column = this.study.columns[axis];
    return this.at(axis, shareOf(column, column.values[run]));
  }

  private draw(context: CanvasRenderingContext2D, colors: Colors): void {
    const { study, selection } = this, main = study.columns[study.main];
    context.clearRect(0, 0, this.sheet.width, this.sheet.height);
    const inside: number[] = [];
    context.lineWidth = 1;
    context.globalAlpha = 0.35;
    for (let run = 0; run < study.runs.length; ++run) {
      if (selection.holds(run)) inside.push(run);
      else this.line(context, run, colors.grid);
    }
    // The more lines, the more they let through.
    context.globalAlpha = Math.min(0.8, Math.max(0.06, 40 / Math.max(1, inside.length)));
    for (const run of inside) this.line(context, run, rampColor(shareOf(main, main.values[run])));
    context.globalAlpha = 1;
    if (selection.chosen >= 0) {
      context.lineWidth = 2.5;
      this.line(context, selection.chosen, colors.text);
    }
    study.columns.forEach((_, axis) => this.axis(context, axis, colors));
  }

  private line(context: CanvasRenderingContext2D, run: number, color: string): void {
    context.strokeStyle = color;
    context.beginPath();
    let isBroken = true;
    for (let axis = 0; axis < this.study.columns.length; ++axis) {
      const { x, y } = this.point(run, axis);
      if (!Number.isFinite(x + y)) isBroken = true;
      else if (isBroken) context.moveTo(x, y), (isBroken = false);
      else context.lineTo(x, y);
    }
    context.stroke();
  }

  private axis(context: CanvasRenderingContext2D, axis: number, colors: Colors): void {
    const column = this.study.columns[axis], low = this.at(axis, 0), high = this.at(axis, 1);
    context.strokeStyle = colors.quiet;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(low.x, low.y);
    context.lineTo(high.x, high.y);
    context.stroke();
    this.range(context, axis, colors);
    const last = Math.max(1, this.study.columns.length - 1);
    const room = this.isLying ? this.sheet.width - 40 : Math.max(50, (this.sheet.width - 2 * side) / last - 8);
    const write = (text: string, x: number, y: number, align: CanvasTextAlign, color: string, width: number): void => {
      const line = fitted(context, text, width);
      context.textAlign = align;
      // An edge of the background, so that lines behind it do not cross it.
      context.strokeStyle = colors.box;
      context.lineWidth = 4;
      context.strokeText(line, x, y);
      context.fillStyle = color;
      context.fillText(line, x, y);
    };
    if (this.isLying) {
      write(column.name, (low.x + high.x) / 2, low.y - 8, "center", column.isParameter ? colors.text : colors.accent, 0.5 * room);
      write(number(column.low), low.x - 14, low.y - 8, "left", colors.quiet, 0.3 * room);
      write(number(column.high), high.x + 14, low.y - 8, "right", colors.quiet, 0.3 * room);
    } else {
      write(column.name, high.x, 12, "center", column.isParameter ? colors.text : colors.accent, room);
      write(number(column.high), high.x, top - 6, "center", colors.quiet, room);
      write(number(column.low), low.x, low.y + 16, "center", colors.quiet, room);
    }
  }

  /** The range that is kept, or that a drag is about to keep. */
  private range(context: CanvasRenderingContext2D, axis: number, colors: Colors): void {
    const column = this.study.columns[axis], kept = this.selection.ranges.get(axis);
    const shares = this.drag?.axis === axis ? [this.drag.begin, this.drag.end] : kept?.map((value) => shareOf(column, value));
    if (!shares) return;
    const a = this.at(axis, shares[0]), b = this.at(axis, shares[1]);
    context.globalAlpha = 0.4;
    context.strokeStyle = colors.accent;
    context.lineWidth = 12;
    context.beginPath();
    context.moveTo(a.x, a.y);
    context.lineTo(b.x, b.y);
    context.stroke();
    context.globalAlpha = 1;
  }
}

/** Distance of a place from a line from a to b; infinite if one of them is not known. */
export function distanceTo(place: Point, a: Point, b: Point): number {
  const dx = b.x - a.x, dy = b.y - a.y;
  const share = Math.min(1, Math.max(0, ((place.x - a.x) * dx + (place.y - a.y) * dy) / (dx * dx + dy * dy)));
  const distance = Math.hypot(place.x - a.x - share * dx, place.y - a.y - share * dy);
  return Number.isFinite(distance) ? distance : Infinity;
}
