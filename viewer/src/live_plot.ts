import uPlot from "uplot";
import { palette } from "./colors";
import { el } from "./dom";
import * as format from "./format";
import type { LiveSource } from "./live_source";

const curves: [string, string][] = [["kinetic", palette.skyBlue], ["potential", palette.orange], ["elastic", palette.purple]];

/** The energies of the last output times. */
export class LivePlot {
  readonly element = el("div", { class: "plots" });
  private readonly chart: uPlot;

  constructor(private readonly source: LiveSource) {
    const box = el("section", { class: "plot" }, el("h3", {}, "Energy", el("small", { text: " [J]" })));
    this.element.append(box);
    const style = (name: string) => () => getComputedStyle(this.element).getPropertyValue(name);
    const axis = { stroke: style("--text"), grid: { stroke: style("--grid"), width: 1 }, ticks: { stroke: style("--grid"), width: 1 } };
    this.chart = new uPlot({
      width: 300, height: 150, scales: { x: { time: false } }, cursor: { points: { size: 5 } },
      axes: [{ ...axis, size: 28 }, { ...axis, size: 62, values: (_, ticks) => ticks.map((tick) => format.number(tick, 4)) }],
      series: [{ label: "t" }, ...curves.map(([label, stroke]) => ({ label, stroke, width: 1.6, points: { show: false }, value: (_: uPlot, value: number) => (value == null ? "–" : format.number(value, 6)) }))],
    }, [[], ...curves.map(() => [])], box);
    new ResizeObserver(() => box.clientWidth > 0 && this.chart.setSize({ width: box.clientWidth - 12, height: 150 })).observe(box);
  }

  update(): void {
    const column = (name: string): number[] => Array.from(this.source.series.get(name) ?? []);
    this.chart.setData([column("time"), ...curves.map(([name]) => column(name))]);
  }

  redraw(): void {
    this.chart.redraw(false, true);
  }
}
