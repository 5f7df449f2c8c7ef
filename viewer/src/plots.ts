import uPlot from "uplot";
import { palette } from "./colors";
import { el } from "./dom";
import * as format from "./format";
import type { Motion } from "./frames";
import { turned, vectorAt } from "./marks";
import { lastAtMost } from "./search";
import type { FrameSource } from "./source";

interface Curve {
  label: string;
  color: string;
  values: ArrayLike<number>;
}
interface Plot {
  title: string;
  unit: string;
  curves: (source: FrameSource) => Curve[];
}

const column = (source: FrameSource, name: string): Float64Array => source.series.get(name) ?? new Float64Array();
const sum = (...columns: Float64Array[]): Float64Array => columns[0].map((_, i) => columns.reduce((total, values) => total + values[i], 0));
const isUsed = (curve: Curve): boolean => Array.from(curve.values).some((value) => value !== 0);

const plots: Plot[] = [
  {
    title: "Energy", unit: "J",
    curves: (source) => {
      const [kinetic, potential, elastic, work] = ["kinetic", "potential", "elastic", "work"].map((name) => column(source, name));
      return [
        { label: "kinetic", color: palette.skyBlue, values: kinetic },
        { label: "potential", color: palette.orange, values: potential },
        ...[{ label: "elastic", color: palette.purple, values: elastic }, { label: "work", color: palette.yellow, values: work }].filter(isUsed),
        { label: "total", color: palette.green, values: sum(kinetic, potential, elastic) },
      ];
    },
  },
  {
    title: "Momentum", unit: "kg m/s; kg m²/s",
    curves: (source) => [
      { label: "linear", color: palette.skyBlue, values: column(source, "momentum") },
      { label: "angular", color: palette.orange, values: column(source, "angular_momentum") },
    ],
  },
  {
    title: "Deepest penetration", unit: "m",
    curves: (source) => [{ label: "depth", color: palette.vermilion, values: column(source, "penetration") }],
  },
  {
    title: "Solver effort an interval", unit: "",
    curves: (source) => [
      { label: "steps", color: palette.skyBlue, values: column(source, "steps") },
      { label: "impacts", color: palette.vermilion, values: column(source, "impacts") },
      { label: "iterations", color: palette.purple, values: column(source, "iterations") },
    ],
  },
];

/** Quantities of one body, each a number a frame. */
export const bodyQuantities: Record<string, { unit: string; labels: string[] }> = {
  position: { unit: "m", labels: ["x", "y", "z"] },
  velocity: { unit: "m/s", labels: ["x", "y", "z"] },
  "angular velocity": { unit: "rad/s", labels: ["x", "y", "z"] },
  "kinetic energy": { unit: "J", labels: ["translation", "rotation"] },
};

/** The curves of a chosen quantity of a moving body. */
export function bodyCurves(source: FrameSource, body: number, quantity: string): number[][] {
  const i = source.frames.moving.indexOf(body);
  const { labels } = bodyQuantities[quantity];
  const rows = source.frameTimes.length;
  const curves = labels.map(() => new Array<number>(rows));
  if (i < 0) return curves.map((curve) => curve.fill(0));
  const n = source.frames.moving.length;
  const { mass, moments } = source.header.bodies[body];
  const q = new Float32Array(4);
  for (let k = 0; k < rows; ++k) {
    const place = k * n + i;
    let values: number[];
    if (quantity === "position") values = vectorAt(source.frames.position, place).map((x, c) => x + source.header.origin[c]);
    else if (quantity === "velocity") values = vectorAt(source.frames.velocity, place);
    else if (quantity === "angular velocity") values = vectorAt(source.frames.spin, place);
    else {
      source.frames.orientation(k, i, q, 0);
      values = kineticEnergy(mass, moments, vectorAt(source.frames.velocity, place), vectorAt(source.frames.spin, place), [q[3], q[0], q[1], q[2]]);
    }
    values.forEach((value, c) => (curves[c][k] = value));
  }
  return curves;
}

/** Of translation and of rotation [J]: ½ m v², ½ ω · I ω with ω turned into the principal frame. */
export function kineticEnergy(mass: number, moments: ArrayLike<number>, v: ArrayLike<number>, w: ArrayLike<number>, q: [number, number, number, number]): [number, number] {
  const own = turned([q[0], -q[1], -q[2], -q[3]], [w[0], w[1], w[2]]);
  return [
    0.5 * mass * (v[0] ** 2 + v[1] ** 2 + v[2] ** 2),
    0.5 * (moments[0] * own[0] ** 2 + moments[1] * own[1] ** 2 + moments[2] * own[2] ** 2),
  ];
}

type TimesOf = (source: FrameSource) => Float64Array;
const seriesTimes: TimesOf = ({ times }) => times;
const frameTimes: TimesOf = ({ frameTimes: own }) => own;

/** The plots under the scene: one cursor for all, a line at the replay's time; a click seeks. */
export class Plots {
  readonly element = el("div", { class: "plots" });
  readonly charts: uPlot[] = [];
  private readonly sync = uPlot.sync("time");
  private readonly lines = new Map<uPlot, HTMLElement>();
  private readonly boxes: HTMLElement[] = [];
  private readonly units: HTMLElement[] = [];
  private readonly bodyBox: HTMLElement;
  private readonly quantity: HTMLSelectElement;
  private body = -1;
  private time = 0;

  constructor(private readonly source: FrameSource, private readonly ghost: FrameSource | undefined, private readonly seek: (time: number) => void) {
    this.quantity = el("select", { "aria-label": "Quantity of the body", onchange: () => this.showBody(this.body) },
      ...Object.keys(bodyQuantities).map((name) => el("option", { value: name }, name)));
    this.bodyBox = el("section", { class: "plot" });
    plots.forEach((plot, i) => {
      this.units.push(el("small"));
      this.boxes.push(el("section", { class: "plot" }, el("h3", {}, plot.title, this.units[i])));
      this.element.append(this.boxes[i]);
      this.charts.push(this.chart(this.boxes[i], ...this.curvesOf(i)));
    });
    this.element.append(this.bodyBox);
    this.showBody(-1);
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  /** These two take up what a live source has now: of the run, of the chosen body. */
  refresh(): void {
    plots.forEach((_, i) => {
      const [own, other] = this.curvesOf(i);
      // A curve that was nothing so far has no place in the legend.
      if (own.length + other.length + 1 !== this.charts[i].series.length) {
        this.remove(this.charts[i]);
        this.charts[i] = this.chart(this.boxes[i], own, other);
      } else {
        setData(this.charts[i], this.tableOf(own, other, seriesTimes));
      }
    });
  }
  refreshBody(): void {
    if (this.charts.length > plots.length) setData(this.charts[plots.length], this.tableOf(...this.bodyCurvesOf(), frameTimes));
  }

  /** Shows a quantity of this body (none: a hint). */
  showBody(body: number): void {
    this.body = body;
    if (this.charts.length > plots.length) this.remove(this.charts.pop());
    const name = this.source.header.bodies[body]?.name;
    const { unit } = bodyQuantities[this.quantity.value];
    this.bodyBox.replaceChildren(el("h3", {}, name ?? "Chosen body", el("small", { text: name ? ` [${unit}]` : "" }), name ? this.quantity : undefined));
    if (!name || !this.source.frames.moving.includes(body)) {
      this.bodyBox.append(el("p", { class: "hint", text: name ? "This body stands still." : "Click a body in the scene to plot its motion." }));
      return;
    }
    this.charts.push(this.chart(this.bodyBox, ...this.bodyCurvesOf(), frameTimes));
    this.resize();
  }

  setTime(time: number): void {
    this.time = time;
    for (const [chart, line] of this.lines) {
      const x = chart.valToPos(time, "x");
      line.style.transform = `translateX(${x}px)`;
      line.hidden = !(x >= 0 && x <= chart.over.clientWidth);
      // Where the pointer is not, the legend tells the values of this moment.
      if ((chart.cursor.left ?? -1) < 0) chart.setLegend({ idx: lastAtMost(chart.data[0], time) }, false);
    }
  }

  /** Colours of axes and grid come from the page's style. */
  redraw(): void {
    for (const chart of this.charts) chart.redraw(false, true);
  }

  /** Curves of the i-th plot, of the run and of its ghost, in the unit that is told beside its title. */
  private curvesOf(i: number): [Curve[], Curve[]] {
    const own = plots[i].curves(this.source);
    const other = this.ghost ? plots[i].curves(this.ghost) : [];
    const power = powerOf([...own, ...other]);
    const unit = [power === 0 ? "" : `10${superscript(power)}`, plots[i].unit].filter(Boolean).join(" ");
    this.units[i].textContent = unit && ` [${unit}]`;
    return [scaled(own, power), scaled(other, power)];
  }

  /** Curves of the chosen body's quantity, of the run and of its ghost. */
  private bodyCurvesOf(): [Curve[], Curve[]] {
    const hues = [palette.vermilion, palette.green, palette.skyBlue];
    const { labels } = bodyQuantities[this.quantity.value];
    const curvesOf = (source: FrameSource, index: number): Curve[] =>
      bodyCurves(source, index, this.quantity.value).map((values, i) => ({ label: labels[i], color: hues[i], values }));
    const name = this.source.header.bodies[this.body]?.name;
    if (!name) return [[], []];
    const twin = this.ghost?.header.bodies.findIndex((candidate) => candidate.name === name) ?? -1;
    return [curvesOf(this.source, this.body), this.ghost && twin >= 0 ? curvesOf(this.ghost, twin) : []];
  }

  private tableOf(own: Curve[], ghost: Curve[], timesOf: TimesOf): uPlot.AlignedData {
    const table = (source: FrameSource, curves: Curve[]): uPlot.AlignedData => [Array.from(timesOf(source)), ...curves.map(({ values }) => Array.from(values))];
    return this.ghost && ghost.length > 0 ? uPlot.join([table(this.source, own), table(this.ghost, ghost)]) : table(this.source, own);
  }

  private remove(chart: uPlot | undefined): void {
    if (!chart) return;
    chart.destroy();
    this.lines.delete(chart);
  }

  private chart(box: HTMLElement, own: Curve[], ghost: Curve[], timesOf: TimesOf = seriesTimes): uPlot {
    const data = this.tableOf(own, ghost, timesOf);
    const style = (name: string) => () => getComputedStyle(this.element).getPropertyValue(name);
    const axis = { stroke: style("--text"), grid: { stroke: style("--grid"), width: 1 }, ticks: { stroke: style("--grid"), width: 1 } };
    const curve = ({ label, color }: Curve, isGhost: boolean): uPlot.Series => ({
      label: isGhost ? `${label} B` : label, stroke: color, width: isGhost ? 1 : 1.6, dash: isGhost ? [5, 4] : undefined, spanGaps: true,
      points: { show: false }, value: (_, value) => (value == null ? "–" : format.number(value, 6)),
    });
    const line = el("div", { class: "now" });
    const chart = new uPlot({
      width: Math.max(200, box.clientWidth), height: 150,
      cursor: { sync: { key: this.sync.key }, drag: { x: true, y: false }, points: { size: 5 } },
      scales: { x: { time: false }, y: { range: (_, low, high) => paddedRange(low, high) } },
      axes: [{ ...axis, size: 28 }, { ...axis, size: 62, values: (_, ticks) => ticks.map((tick) => format.number(tick, 4)) }],
      series: [{ label: "t", value: (_, value) => (value == null ? "–" : `${format.number(value, 6)} s`) },
        ...own.map((c) => curve(c, false)), ...ghost.map((c) => curve(c, true))],
      hooks: { setScale: [() => this.setTime(this.time)] },
    }, data, box);
    chart.over.append(line);
    this.lines.set(chart, line);
    let downAt = 0;
    chart.over.addEventListener("pointerdown", (event) => (downAt = event.clientX));
    chart.over.addEventListener("click", (event) => {
      if (Math.abs(event.clientX - downAt) < 4) this.seek(chart.posToVal(event.offsetX, "x"));
    });
    return chart;
  }

  private resize(): void {
    for (const chart of this.charts) {
      const width = chart.root.parentElement?.clientWidth ?? 0;
      if (width > 0 && width !== chart.width) chart.setSize({ width, height: 150 });
    }
    this.setTime(this.time);
  }
}

/** New values; a part that the reader has chosen to look at stays. */
function setData(chart: uPlot, data: uPlot.AlignedData): void {
  const [times] = chart.data;
  const { min, max } = chart.scales.x;
  const isWhole = min == null || max == null || (min <= times[0] && max >= times[times.length - 1]);
  chart.setData(data, isWhole);
  if (!isWhole) chart.redraw();
}

/** Power of a thousand that makes very small or large values readable: 0 for those between a thousandth and a million. */
function powerOf(curves: Curve[]): number {
  let most = 0;
  for (const { values } of curves) for (let i = 0; i < values.length; ++i) most = Math.max(most, Math.abs(values[i]));
  return most === 0 || !Number.isFinite(most) || (most >= 1e-3 && most < 1e6) ? 0 : 3 * Math.floor(Math.log10(most) / 3);
}

function scaled(curves: Curve[], power: number): Curve[] {
  if (power === 0) return curves;
  return curves.map((curve) => ({ ...curve, values: Array.from(curve.values, (value) => value / 10 ** power) }));
}

function superscript(power: number): string {
  return String(power).replace(/./g, (digit) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(digit)]);
}

/** A little room above and below; of a constant some more, of nothing at all from 0 to 1. */
function paddedRange(low: number | null, high: number | null): [number, number] {
  if (low == null || high == null || (low === 0 && high === 0)) return [0, 1];
  const room = 0.06 * (high - low) || 0.1 * Math.abs(high);
  return [low === 0 ? 0 : low - room, high + room];
}

/** Kinetic energies of a body at a moment [J]. */
export function energyNow(source: FrameSource, body: number, motion: Motion): [number, number] {
  const { mass, moments } = source.header.bodies[body];
  const q = motion.orientation;
  return kineticEnergy(mass, moments, vectorAt(motion.velocity, body), vectorAt(motion.spin, body),
    [q[4 * body + 3], q[4 * body], q[4 * body + 1], q[4 * body + 2]]);
}
