import { button, el } from "../dom";
import { number, replayOf, type Study } from "./data";
import { summary, type Selection } from "./selection";

/** Beside the plots: the run that is chosen, its numbers, and how it is replayed. */
export class ChosenRun {
  private readonly input: HTMLInputElement;
  private readonly body = el("div", {});
  private readonly within = el("p", { class: "hint", role: "status" });
  private readonly clear: HTMLButtonElement;

  constructor(box: HTMLElement, private readonly study: Study, private readonly selection: Selection) {
    this.input = el("input", { type: "number", min: 0, "aria-label": "number of a run", onchange: () => this.goTo(Number(this.input.value)) });
    this.clear = button("All runs", "take away all ranges", () => selection.clear());
    box.append(
      el("p", { class: "choices" }, el("label", {}, "run ", this.input),
         button("‹", "the run before", () => this.step(-1)), button("›", "the next run", () => this.step(1))),
      this.body, this.within, this.clear);
    selection.listen(() => this.show());
    this.show();
  }

  private step(by: number): void {
    const count = this.study.runs.length;
    for (let i = 1; i <= count; ++i) {
      const next = (Math.max(this.selection.chosen, by > 0 ? -1 : 0) + by * i + count * i) % count;
      if (this.selection.holds(next)) return this.selection.choose(next);
    }
  }

  /** Chooses the run of this number, or the one of the page that is next to it. */
  private goTo(run: number): void {
    const { runs } = this.study;
    const next = runs.findIndex((other) => other >= run);
    if (runs.length > 0) this.selection.choose(next < 0 ? runs.length - 1 : next);
  }

  private show(): void {
    const { study, selection } = this, { count, mean } = summary(study, selection), main = study.columns[study.main];
    this.within.textContent = `${count} of ${study.runs.length} runs within the ranges${main ? `; mean of ${main.name}: ${number(mean)}` : ""}`;
    this.clear.hidden = selection.ranges.size === 0;
    const index = selection.chosen;
    if (index < 0) {
      this.body.replaceChildren(el("p", { class: "hint" }, "Click a dot or a line to choose its run."));
      return;
    }
    const run = study.runs[index];
    this.input.value = String(run);
    const reason = study.reasons[run];
    const rows = study.columns.map(({ name, values }) => el("tr", {}, el("th", {}, name), el("td", {}, number(values[index]))));
    this.body.replaceChildren(
      el("h3", {}, `Run ${run}: ${study.status[index]}`), el("p", {}, reason ? reason : undefined), this.replay(run), el("table", {}, ...rows));
  }

  private replay(run: number): HTMLElement {
    const replay = replayOf(this.study, run);
    if ("address" in replay)
      return el("a", { class: "replay", href: replay.address, target: "_blank", rel: "noopener" }, `▶ Replay run ${run}`);
    return el("div", {}, el("p", { class: "hint" }, "This replays it; with `rigor study FILE --view` a click does:"),
              el("code", {}, replay.command),
              button("Copy", "copy the command", () => void navigator.clipboard?.writeText(replay.command)));
  }
}
