import { el } from "../dom";
import { number, shareOf, ticks, type Column, type Study } from "./data";
import type { Selection } from "./selection";
import { fitted, rampColor, Sheet, type Colors } from "./sheet";

const left = 62, right = 16, top = 14, bottom = 44;

/** One column over another, a dot a run: a click chooses the nearest. The reader says which columns. */
export class ScatterPlot {
  private readonly sheet: Sheet;
  private x: number;
  private y: number;

  constructor(box: HTMLElement, private readonly study: Study, private readonly selection: Selection) {
    this.y = study.main;
    this.x = Math.max(0, study.columns.findIndex((column, i) => column.isParameter && i !== this.y));
    box.append(el("p", { class: "choices" },
      el("label", {}, "over ", this.choice(this.x, (i) => (this.x = i))),
      el("label", {}, "of ", this.choice(this.y, (i) => (this.y = i)))));
    this.sheet = new Sheet(box, "a dot for each run; the columns are chosen above", (width) => Math.min(380, Math.max(260, 0.55 * width)),
                           (context, colors) => this.draw(context, colors));
    this.sheet.canvas.addEventListener("click", (event) => this.click(event as PointerEvent));
    selection.listen(() => this.sheet.redraw());
  }

  private choice(chosen: number, set: (column: number) => void): HTMLSelectElement {
    const options = this.study.columns.map(({ name }, i) => el("option", { value: i, selected: i === chosen }, name));
    const select = el("select", { onchange: () => {
      set(Number(select.value));
      this.sheet.redraw();
    } }, ...options);
    return select;
  }

  private place(run: number): { x: number; y: number } {
    const { width, height } = this.sheet, x = this.study.columns[this.x], y = this.study.columns[this.y];
    return {
      x: left + shareOf(x, x.values[run]) * (width - left - right),
      y: height - bottom - shareOf(y, y.values[run]) * (height - top - bottom),
    };
  }

  private click(event: PointerEvent): void {
    const at = this.sheet.place(event);
    let best = -1, least = 14;
    for (let run = 0; run < this.study.runs.length; ++run) {
      if (!this.selection.holds(run)) continue;
      const { x, y } = this.place(run), distance = Math.hypot(x - at.x, y - at.y);
      if (distance < least) (least = distance), (best = run);
    }
    if (best >= 0) this.selection.choose(best);
  }

  private draw(context: CanvasRenderingContext2D, colors: Colors): void {
    const { study, selection } = this, main = study.columns[study.main];
    context.clearRect(0, 0, this.sheet.width, this.sheet.height);
    this.axes(context, colors);
    const dot = (run: number, color: string, radius: number): void => {
      const { x, y } = this.place(run);
      if (!Number.isFinite(x + y)) return;
      context.fillStyle = color;
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.fill();
    };
    const radius = study.runs.length > 1000 ? 2 : 3.5;
    for (let run = 0; run < study.runs.length; ++run) {
      if (!selection.holds(run)) dot(run, colors.grid, radius);
    }
    context.globalAlpha = study.runs.length > 1000 ? 0.6 : 0.9;
    for (let run = 0; run < study.runs.length; ++run) {
      if (selection.holds(run)) dot(run, rampColor(shareOf(main, main.values[run])), radius);
    }
    context.globalAlpha = 1;
    if (selection.chosen < 0) return;
    dot(selection.chosen, colors.text, radius + 3);
    dot(selection.chosen, colors.box, radius + 1);
    dot(selection.chosen, colors.accent, radius);
  }

  private axes(context: CanvasRenderingContext2D, colors: Colors): void {
    const { width, height } = this.sheet, x = this.study.columns[this.x], y = this.study.columns[this.y];
    const stroke = (x1: number, y1: number, x2: number, y2: number): void => {
      context.beginPath();
      context.moveTo(x1, y1);
      context.lineTo(x2, y2);
      context.stroke();
    };
    const marks = (column: Column, count: number): number[] => ticks(column.low, column.high, count);
    context.strokeStyle = colors.grid;
    context.fillStyle = colors.quiet;
    context.lineWidth = 1;
    context.textAlign = "center";
    for (const mark of marks(x, width < 500 ? 4 : 7)) {
      const at = left + shareOf(x, mark) * (width - left - right);
      stroke(at, top, at, height - bottom);
      context.fillText(number(mark), at, height - bottom + 16);
    }
    context.textAlign = "right";
    for (const mark of marks(y, 5)) {
      const at = height - bottom - shareOf(y, mark) * (height - top - bottom);
      stroke(left, at, width - right, at);
      context.fillText(fitted(context, number(mark), left - 8), left - 6, at + 4);
    }
    context.fillStyle = colors.text;
    context.textAlign = "center";
    context.fillText(fitted(context, x.name, width - left - right), (left + width - right) / 2, height - 8);
  }
}
