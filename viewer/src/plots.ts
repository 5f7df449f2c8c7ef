import { Charts, powerOf, scaled, unitText, valueUnit, type Curve } from "./chart";
import { palette } from "./colors";
import { el } from "./dom";
import type { Motion } from "./frames";
import { turned, vectorAt } from "./marks";
import type { FrameSource } from "./source";

interface Plot {
  title: string;
  unit: string;
  curves: (source: FrameSource) => Omit<Curve, "times">[];
}

/** A stored series of a run; empty if it has none of that name. */
export const column = (source: FrameSource, name: string): Float64Array => source.series.get(name) ?? new Float64Array();
/** Kinetic, potential and elastic energy together. */
export function totalEnergy(source: FrameSource): Float64Array {
  const [kinetic, potential, elastic] = ["kinetic", "potential", "elastic"].map((name) => column(source, name));
  return kinetic.map((value, i) => value + potential[i] + elastic[i]);
}
const isUsed = (curve: { values: ArrayLike<number> }): boolean => Array.from(curve.values).some((value) => value !== 0);

const plots: Plot[] = [
  {
    title: "Energy", unit: "J",
    curves: (source) => {
      const [kinetic, potential, elastic, work] = ["kinetic", "potential", "elastic", "work"].map((name) => column(source, name));
      return [
        { label: "kinetic", color: palette.skyBlue, values: kinetic },
        { label: "potential", color: palette.orange, values: potential },
        ...[{ label: "elastic", color: palette.purple, values: elastic }, { label: "work", color: palette.yellow, values: work }].filter(isUsed),
        { label: "total", color: palette.green, values: totalEnergy(source) },
      ];
    },
  },
  {
    title: "Momentum", unit: "kg m/s; kg m²/s",
    curves: (source) => [
      { label: "linear", color: palette.skyBlue, unit: "kg m/s", values: column(source, "momentum") },
      { label: "angular", color: palette.orange, unit: "kg m²/s", values: column(source, "angular_momentum") },
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

/** The plots of a run under the scene. */
export class Plots {
  readonly element = el("div", { class: "plots" });
  private readonly all: Charts;
  private readonly units = plots.map(() => el("small"));
  private readonly bodyBox: HTMLElement;
  private readonly quantity: HTMLSelectElement;
  private body = -1;

  constructor(private readonly source: FrameSource, seek: (time: number) => void) {
    this.all = new Charts(this.element, seek);
    this.quantity = el("select", { "aria-label": "Quantity of the body", onchange: () => this.showBody(this.body) },
      ...Object.keys(bodyQuantities).map((name) => el("option", { value: name }, name)));
    this.bodyBox = el("section", { class: "plot" });
    plots.forEach((plot, i) => {
      const box = el("section", { class: "plot" }, el("h2", {}, plot.title, this.units[i]));
      this.element.append(box);
      this.all.add(box, this.curvesOf(i));
    });
    this.element.append(this.bodyBox);
    this.showBody(-1);
  }

  get charts() {
    return this.all.list;
  }

  /** These two take up what a live source has now: of the run, of the chosen body. */
  refresh(): void {
    plots.forEach((_, i) => this.all.replace(i, this.curvesOf(i)));
  }
  refreshBody(): void {
    if (this.charts.length > plots.length) this.all.replace(plots.length, this.bodyCurvesOf());
  }

  /** Shows a quantity of this body (none: a hint). */
  showBody(body: number): void {
    this.body = body;
    this.all.keep(plots.length);
    const name = this.source.header.bodies[body]?.name;
    const { unit } = bodyQuantities[this.quantity.value];
    this.bodyBox.replaceChildren(el("h2", {}, name ?? "Chosen body", el("small", { text: name ? ` [${unit}]` : "" }), name ? this.quantity : undefined));
    if (!name || !this.source.frames.moving.includes(body)) {
      this.bodyBox.append(el("p", { class: "hint", text: name ? "This body stands still." : "Click a body in the scene to plot its motion." }));
      return;
    }
    this.all.add(this.bodyBox, this.bodyCurvesOf());
    this.all.resize();
  }

  setTime(time: number): void {
    this.all.setTime(time);
  }

  redraw(): void {
    this.all.redraw();
  }

  /** Curves of the i-th plot, in the unit that is told beside its title. */
  private curvesOf(i: number): Curve[] {
    const { times } = this.source;
    const curves = plots[i].curves(this.source).map((curve) => ({ ...curve, times }));
    const power = powerOf(curves);
    this.units[i].textContent = unitText(plots[i].unit, power);
    return scaled(curves, power).map((curve) => ({ ...curve, unit: valueUnit(curve.unit ?? plots[i].unit, power) }));
  }

  /** Curves of the chosen body's quantity. */
  private bodyCurvesOf(): Curve[] {
    const hues = [palette.vermilion, palette.green, palette.skyBlue];
    const { labels, unit } = bodyQuantities[this.quantity.value];
    const times = this.source.frameTimes;
    return bodyCurves(this.source, this.body, this.quantity.value).map((values, i) => ({ label: labels[i], color: hues[i], times, values, unit: valueUnit(unit, 0) }));
  }
}

/** Kinetic energies of a body at a moment [J]. */
export function energyNow(source: FrameSource, body: number, motion: Motion): [number, number] {
  const { mass, moments } = source.header.bodies[body];
  const q = motion.orientation;
  return kineticEnergy(mass, moments, vectorAt(motion.velocity, body), vectorAt(motion.spin, body),
    [q[4 * body + 3], q[4 * body], q[4 * body + 1], q[4 * body + 2]]);
}
