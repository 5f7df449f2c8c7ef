import { Charts, powerOf, scaled, unitText, valueUnit, type Curve } from "./chart";
import { el } from "./dom";
import { bodyCurves, bodyQuantities, column, totalEnergy } from "./plots";
import type { Chosen } from "./run_choice";
import { runColor, runNames, shortNames } from "./run_names";
import type { RecordedSource } from "./source";

interface ComparePlot {
  title: string;
  unit: string;
  values: (source: RecordedSource) => ArrayLike<number>;
}

const plots: ComparePlot[] = [
  { title: "Total energy", unit: "J", values: totalEnergy },
  { title: "Kinetic energy", unit: "J", values: (source) => column(source, "kinetic") },
  { title: "Momentum", unit: "kg m/s", values: (source) => column(source, "momentum") },
  { title: "Deepest penetration", unit: "m", values: (source) => column(source, "penetration") },
];

/** The same quantity of several runs in one chart: of A and B, or of all runs. */
export class ComparePlots {
  readonly element: HTMLElement;
  private readonly boxes = el("div", { class: "plots" });
  private readonly all: Charts;
  private readonly legend = el("span", { class: "legend" });
  private readonly wantsAll: HTMLInputElement;
  private readonly bodyBox = el("section", { class: "plot" });
  private readonly quantity: HTMLSelectElement;
  private readonly names: string[];
  private readonly short: string[];
  private body = "";
  private isQuantityChosen = false;

  constructor(private readonly sources: RecordedSource[], private chosen: Chosen, seek: (time: number) => void) {
    this.all = new Charts(this.boxes, seek);
    this.names = runNames(sources);
    this.short = shortNames(this.names);
    this.wantsAll = el("input", { type: "checkbox", id: "all-runs", onchange: () => this.show() });
    this.quantity = el("select", { "aria-label": "Quantity of the body", onchange: () => {
      this.isQuantityChosen = true;
      this.showBodyPlot();
    } }, ...Object.entries(bodyQuantities).flatMap(([name, { labels }]) => labels.map((label, i) => el("option", { value: `${name}/${i}` }, `${name} ${label}`))));
    this.element = el("div", { class: "compare-plots" },
      el("div", { class: "plots-head" }, el("label", {}, this.wantsAll, "all runs"), this.legend), this.boxes);
    this.show();
  }

  get charts() {
    return this.all.list;
  }

  setRuns(chosen: Chosen): void {
    this.chosen = chosen;
    this.show();
  }

  /** Shows a quantity of the body of that index in A, and of its namesakes (none: a hint). */
  showBody(body: number): void {
    const source = this.sources[this.chosen.a];
    this.body = source.header.bodies[body]?.name ?? "";
    // Until the reader wants another one: the coordinate in which the body moves most.
    if (this.body && !this.isQuantityChosen) this.quantity.value = `position/${widest(bodyCurves(source, body, "position"))}`;
    this.showBodyPlot();
  }

  setTime(time: number): void {
    this.all.setTime(time);
  }

  redraw(): void {
    this.all.redraw();
  }

  /** Runs whose curves are drawn. */
  private shownRuns(): number[] {
    const { a, b } = this.chosen;
    return this.sources.map((_, i) => i).filter((run) => this.wantsAll.checked || run === a || run === b);
  }

  /** A curve of each of these runs. Each is wider than the next, so that all are seen where they lie on each other; B is dashed. */
  private curvesOf(runs: number[], values: (run: number) => ArrayLike<number>): Curve[] {
    const step = Math.min(1, 3.5 / Math.max(1, runs.length - 1));
    return runs.map((run, i) => ({
      label: this.short[run], color: runColor(run), times: this.sources[run].times, values: values(run),
      width: 1.6 + step * (runs.length - 1 - i), isDashed: run === this.chosen.b,
    }));
  }

  private show(): void {
    const runs = this.shownRuns();
    this.legend.replaceChildren(...runs.map((run) => {
      const role = run === this.chosen.a ? " (A)" : run === this.chosen.b ? " (B, dashed)" : "";
      return el("span", {}, el("span", { class: "dot", style: `background:${runColor(run)}` }), this.names[run] + role);
    }));
    this.all.keep(0);
    this.boxes.replaceChildren();
    for (const plot of plots) {
      const curves = this.curvesOf(runs, (run) => plot.values(this.sources[run]));
      const power = powerOf(curves);
      const box = el("section", { class: "plot" }, el("h2", {}, plot.title, el("small", { text: unitText(plot.unit, power) })));
      this.boxes.append(box);
      this.all.add(box, scaled(curves, power).map((curve) => ({ ...curve, unit: valueUnit(plot.unit, power) })));
    }
    this.boxes.append(this.bodyBox);
    this.showBodyPlot();
  }

  /** The body's index in a run, or -1. */
  private twin(run: number): number {
    return this.sources[run].header.bodies.findIndex(({ name }) => name === this.body);
  }

  private showBodyPlot(): void {
    this.all.keep(plots.length);
    const [quantity, part] = this.quantity.value.split("/");
    const { unit } = bodyQuantities[quantity];
    const heading = this.body === "" ? [] : [el("small", { text: ` [${unit}]` }), this.quantity];
    this.bodyBox.replaceChildren(el("h2", {}, this.body || "Chosen body", ...heading));
    const runs = this.shownRuns().filter((run) => this.sources[run].frames.moving.includes(this.twin(run)));
    const curves = this.curvesOf(runs, (run) => bodyCurves(this.sources[run], this.twin(run), quantity)[Number(part)]);
    if (curves.length === 0) {
      this.bodyBox.append(el("p", { class: "hint", text: this.body ? "This body stands still." : "Click a body in the scene to plot its motion." }));
    } else {
      this.all.add(this.bodyBox, curves.map((curve) => ({ ...curve, unit: valueUnit(unit, 0) })));
    }
    this.all.resize();
  }
}

/** Index of the curve whose values span most. */
export function widest(curves: number[][]): number {
  const spans = curves.map((values) => values.reduce((most, value) => Math.max(most, value), -Infinity) - values.reduce((least, value) => Math.min(least, value), Infinity));
  return spans.indexOf(Math.max(...spans));
}
