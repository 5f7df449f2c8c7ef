import { el } from "./dom";
import * as format from "./format";
import { logAxis, placeOn, referenceError, shownPoints, type LogAxis, type Precision, type PrecisionPoint } from "./precision";
import { runColor } from "./run_names";

const space = "http://www.w3.org/2000/svg";
/** Of the drawing, in its own units. */
const size = { width: 420, height: 260, left: 66, right: 12, top: 10, bottom: 44 };

interface PrecisionPlot {
  title: string;
  /** Of the axis across. */
  name: string;
  x: (point: PrecisionPoint) => number;
}

const plots: PrecisionPlot[] = [
  { title: "Error over CPU time", name: "CPU time [s]", x: ({ cpu_time }) => cpu_time },
  { title: "Error over step", name: "step [s]", x: ({ step }) => step },
];

/** Error over CPU time and over the step, both axes logarithmic; runs that differ in the step alone are one curve. */
export function precisionPlots(precision: Precision): HTMLElement {
  const { references, curves } = precision;
  const legend = curves.map(({ label }, i) =>
    el("span", {}, el("span", { class: "dot", style: `background:${runColor(i)}` }), label || "all runs"));
  const exact = curves.flatMap(({ points }) => points).filter(({ error }) => error === 0).length;
  const hint = exact > 0 ? `${exact} ${exact === 1 ? "run has" : "runs have"} no error and no place on a logarithmic axis.` : "";
  // Where all runs agree with the reference there is nothing to plot.
  if (!curves.some(({ points }) => points.some(({ error }) => error !== null && error > 0)))
    return el("section", { class: "precision" }, el("p", { class: "hint", text: "No run differs from the reference: there is no error to plot over work." }));
  return el("section", { class: "precision" },
    el("h2", {}, "Work and precision", el("small", { text: ` errors against: ${references.map(({ name }) => name).join("; ")}` })),
    el("span", { class: "legend" }, ...legend),
    el("div", { class: "plots" }, ...plots.map((plot) => el("section", { class: "plot" }, el("h2", { text: plot.title }), drawing(precision, plot)))),
    hint ? el("p", { class: "hint", text: hint }) : undefined);
}

function svg(tag: string, attributes: Record<string, unknown>, ...children: (Node | string)[]): SVGElement {
  const element = document.createElementNS(space, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

function drawing(precision: Precision, { title, name, x }: PrecisionPlot): SVGElement {
  const shown = precision.curves.map((curve) => shownPoints(curve, x));
  const own = referenceError(precision);
  const across = logAxis(shown.flat().map(x));
  const up = logAxis([...shown.flat().map(({ error }) => error), ...(own === undefined ? [] : [own])]);
  const left = (value: number) => size.left + placeOn(across, value) * (size.width - size.left - size.right);
  const top = (value: number) => size.height - size.bottom - placeOn(up, value) * (size.height - size.top - size.bottom);
  const plot = svg("svg", { viewBox: `0 0 ${size.width} ${size.height}`, role: "img", "aria-label": `${title}, logarithmic axes` });
  plot.append(...axes(across, up, name, left, top));
  if (own !== undefined) plot.append(svg("line", { class: "own", x1: size.left, x2: size.width - size.right, y1: top(own), y2: top(own) }, tip(`the reference's own error, ${format.number(own, 3)} m`)));
  shown.forEach((points, i) => {
    plot.append(svg("polyline", { points: points.map((point) => `${left(x(point))},${top(point.error)}`).join(" "), stroke: runColor(i) }));
    for (const point of points) plot.append(svg("circle", { cx: left(x(point)), cy: top(point.error), r: 4, fill: runColor(i) }, tip(textOf(point))));
  });
  return plot;
}

function axes(across: LogAxis, up: LogAxis, name: string, left: (value: number) => number, top: (value: number) => number): SVGElement[] {
  const bottom = size.height - size.bottom, right = size.width - size.right;
  return [
    ...across.ticks.flatMap((power) => [
      svg("line", { x1: left(10 ** power), x2: left(10 ** power), y1: size.top, y2: bottom }),
      svg("text", { x: left(10 ** power), y: bottom + 15, "text-anchor": "middle" }, `1e${power}`)]),
    ...up.ticks.flatMap((power) => [
      svg("line", { x1: size.left, x2: right, y1: top(10 ** power), y2: top(10 ** power) }),
      svg("text", { x: size.left - 6, y: top(10 ** power) + 4, "text-anchor": "end" }, `1e${power}`)]),
    svg("text", { x: (size.left + right) / 2, y: size.height - 8, "text-anchor": "middle" }, name),
    svg("text", { x: 0, y: 0, "text-anchor": "middle", transform: `translate(14 ${(size.top + bottom) / 2}) rotate(-90)` }, "error [m]"),
  ];
}

function tip(text: string): SVGElement {
  return svg("title", {}, text);
}

function textOf({ label, step, cpu_time, error, order }: PrecisionPoint): string {
  const tail = order === null ? "" : `, observed order ${format.number(order, 3)}`;
  return `${label}: error ${format.number(error, 3)} m, step ${format.number(step, 3)} s, CPU time ${format.number(cpu_time, 3)} s${tail}`;
}
