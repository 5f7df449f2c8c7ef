import uPlot from "uplot";
import { el } from "./dom";
import * as format from "./format";
import { lastAtMost } from "./search";

/** A line of a chart over the times of its run. */
export interface Curve {
  label: string;
  color: string;
  times: Float64Array;
  values: ArrayLike<number>;
  /** That of the values, beside them under the plot: " · 10⁻³ J". */
  unit?: string;
  /** [CSS pixels]; 1.6 if not given. */
  width?: number;
  isDashed?: boolean;
}

const height = 128;

/** Charts under the scene: one cursor for all, a line at the replay's time; a click seeks. */
export class Charts {
  readonly list: uPlot[] = [];
  private readonly sync = uPlot.sync("time");
  private readonly lines = new Map<uPlot, HTMLElement>();
  private time = 0;

  /** `element` holds the boxes that the charts are put into. */
  constructor(private readonly element: HTMLElement, private readonly seek: (time: number) => void) {
    new ResizeObserver(() => this.resize()).observe(element);
  }

  add(box: HTMLElement, curves: Curve[]): void {
    this.list.push(this.chart(box, curves));
  }

  /** Gives the i-th chart these curves; a part that the reader has chosen to look at stays. */
  replace(i: number, curves: Curve[]): void {
    const chart = this.list[i];
    const box = chart.root.parentElement;
    // A curve that was nothing so far has no place in the legend.
    const isOther = curves.length + 1 !== chart.series.length || curves.some(({ label }, k) => chart.series[k + 1].label !== label);
    if (box && isOther) {
      this.remove(chart);
      this.list[i] = this.chart(box, curves);
    } else {
      setData(chart, tableOf(curves));
    }
  }

  /** Removes all charts but the first ones. */
  keep(count: number): void {
    for (const chart of this.list.splice(count)) this.remove(chart);
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
    for (const chart of this.list) chart.redraw(false, true);
  }

  resize(): void {
    for (const chart of this.list) {
      const width = chart.root.parentElement?.clientWidth ?? 0;
      if (width > 0 && width !== chart.width) chart.setSize({ width, height });
    }
    this.setTime(this.time);
  }

  private remove(chart: uPlot): void {
    chart.destroy();
    this.lines.delete(chart);
  }

  private chart(box: HTMLElement, curves: Curve[]): uPlot {
    const style = (name: string) => () => getComputedStyle(this.element).getPropertyValue(name);
    const axis = { stroke: style("--text"), grid: { stroke: style("--grid"), width: 1 }, ticks: { stroke: style("--grid"), width: 1 } };
    const line = el("div", { class: "now" });
    const chart = new uPlot({
      width: Math.max(200, box.clientWidth), height, padding: [6, null, null, null],
      cursor: { sync: { key: this.sync.key }, drag: { x: true, y: false }, points: { size: 5 } },
      scales: { x: { time: false }, y: { range: (_, low, high) => paddedRange(low, high) } },
      axes: [{ ...axis, size: 28 }, { ...axis, size: 62, values: (_, ticks) => ticks.map((tick) => format.number(tick, 4)) }],
      series: [{ label: "t", value: (_, value) => (value == null ? "–" : `${format.number(value, 6)} s`) }, ...curves.map(seriesOf)],
      hooks: { setScale: [() => this.setTime(this.time)] },
    }, tableOf(curves), box);
    chart.over.append(line);
    this.lines.set(chart, line);
    let downAt = 0;
    chart.over.addEventListener("pointerdown", (event) => (downAt = event.clientX));
    chart.over.addEventListener("click", (event) => {
      if (Math.abs(event.clientX - downAt) < 4) this.seek(chart.posToVal(event.offsetX, "x"));
    });
    return chart;
  }
}

/** New values; all of them are seen if all were before. */
function setData(chart: uPlot, data: uPlot.AlignedData): void {
  const [times] = chart.data;
  const { min, max } = chart.scales.x;
  const isWhole = min == null || max == null || (min <= times[0] && max >= times[times.length - 1]);
  chart.setData(data, isWhole);
  if (!isWhole) chart.redraw();
}

function seriesOf({ label, color, width, isDashed, unit = "" }: Curve): uPlot.Series {
  return {
    label, stroke: color, width: width ?? 1.6, dash: isDashed ? [5, 4] : undefined, spanGaps: true,
    points: { show: false }, value: (_, value) => (value == null ? "–" : value === 0 ? "0" : format.number(value, 5) + unit),
  };
}

/** Times of all curves, then for each its values, with gaps where only others have a time. */
export function tableOf(curves: Curve[]): uPlot.AlignedData {
  // Curves of one run share their array of times.
  const runs = [...new Set(curves.map(({ times }) => times))];
  const inOrder = runs.flatMap((times) => curves.filter((curve) => curve.times === times));
  const tables = runs.map((times): uPlot.AlignedData => [Array.from(times), ...curves.filter((curve) => curve.times === times).map(({ values }) => Array.from(values))]);
  if (tables.length === 0) return [[]];
  const [times, ...columns] = tables.length === 1 ? tables[0] : uPlot.join(tables);
  return [times, ...curves.map((curve) => columns[inOrder.indexOf(curve)])];
}

/** Power of a thousand that makes very small or large values readable: 0 for those between a thousandth and a million. */
export function powerOf(curves: Curve[]): number {
  let most = 0;
  for (const { values } of curves) for (let i = 0; i < values.length; ++i) most = Math.max(most, Math.abs(values[i]));
  return most === 0 || !Number.isFinite(most) || (most >= 1e-3 && most < 1e6) ? 0 : 3 * Math.floor(Math.log10(most) / 3);
}

/** The curves divided by that power of ten. */
export function scaled(curves: Curve[], power: number): Curve[] {
  if (power === 0) return curves;
  return curves.map((curve) => ({ ...curve, values: Array.from(curve.values, (value) => value / 10 ** power) }));
}

/** " [10⁻³ J]", or nothing where there is neither. */
export function unitText(unit: string, power: number): string {
  const text = [power === 0 ? "" : tenTo(power), unit].filter(Boolean).join(" ");
  return text && ` [${text}]`;
}

/** The same beside a value: " · 10⁻³ J". */
export function valueUnit(unit: string, power: number): string {
  return [power === 0 ? "" : ` · ${tenTo(power)}`, unit && ` ${unit}`].join("");
}

function tenTo(power: number): string {
  return "10" + String(power).replace(/./g, (digit) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(digit)]);
}

/** A little room above and below; of a constant some more, of nothing at all from 0 to 1. */
function paddedRange(low: number | null, high: number | null): [number, number] {
  if (low == null || high == null || (low === 0 && high === 0)) return [0, 1];
  const room = 0.06 * (high - low) || 0.1 * Math.abs(high);
  return [low === 0 ? 0 : low - room, high + room];
}
