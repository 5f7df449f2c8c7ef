import { button, el, shown } from "./dom";
import * as format from "./format";
import { whyOther } from "./parting";
import { runColor, runNames } from "./run_names";
import type { RecordedSource } from "./source";

/** Which runs are looked at: A is drawn solid, B (-1: none) as its ghost. */
export interface Chosen {
  a: number;
  b: number;
}

/** What is chosen after the reader wants `wanted`: to choose what the other one is swaps them. */
export function nextChoice(before: Chosen, wanted: Chosen): Chosen {
  if (wanted.a !== wanted.b) return wanted;
  if (wanted.a !== before.a) return { a: wanted.a, b: before.a };
  return before.b < 0 ? before : { a: before.b, b: before.a };
}

/** Above the scene of a page with several runs: which one is A, which is B. */
export class RunChoice {
  readonly element: HTMLElement;
  private readonly why = el("p", { class: "hint why", id: "why", role: "status" });
  private readonly rows: { select: HTMLSelectElement; dot: HTMLElement; end: HTMLElement }[];

  constructor(private readonly sources: RecordedSource[], private chosen: Chosen, private readonly changed: (chosen: Chosen) => void) {
    const names = runNames(sources);
    const options = names.map((name, i) => el("option", { value: i }, name));
    this.rows = ["A", "B"].map((name, i) => ({
      select: el("select", { id: `run-${name.toLowerCase()}`, "aria-label": i === 0 ? "Run A, drawn solid" : "Run B, drawn as a ghost", onchange: () => this.read() },
        ...(i === 0 ? [] : [el("option", { value: -1 }, "none")]), ...options.map((option) => option.cloneNode(true))),
      dot: el("span", { class: "dot" }),
      end: el("small"),
    }));
    const [a, b] = this.rows;
    this.element = el("div", { class: "runs", role: "group", "aria-label": "Runs that are looked at" },
      el("label", {}, el("b", { text: "A" }), a.dot, a.select, a.end),
      button("⇄", "Swap A and B", () => this.chosen.b >= 0 && this.set({ a: this.chosen.b, b: this.chosen.a })),
      el("label", { title: "Drawn as a ghost (G)" }, el("b", { text: "B" }), b.dot, b.select, b.end), this.why);
    this.show();
  }

  private read(): void {
    const [a, b] = this.rows.map(({ select }) => Number(select.value));
    this.set(nextChoice(this.chosen, { a, b }));
  }

  private set(chosen: Chosen): void {
    this.chosen = chosen;
    this.show();
    this.changed(chosen);
  }

  private show(): void {
    const [first, second] = [this.sources[this.chosen.a], this.sources[this.chosen.b]];
    this.why.textContent = second ? shown(whyOther(first, second)) : "";
    const last = Math.max(...this.sources.map(({ times }) => times[times.length - 1]));
    this.rows.forEach(({ select, dot, end }, i) => {
      const run = i === 0 ? this.chosen.a : this.chosen.b;
      select.value = String(run);
      dot.style.background = run < 0 ? "transparent" : runColor(run);
      const source = this.sources[run];
      const own = source ? source.times[source.times.length - 1] : last;
      const word = source?.header.stopped ? "stopped at" : "until";
      // Shorter than by the rounding of output times.
      end.textContent = own < last * (1 - 1e-12) ? `${word} ${format.number(own, 6)} s` : "";
      end.title = source?.header.stopped ?? "";
    });
  }
}
