import { runColors } from "./colors";
import { button, el, shown } from "./dom";
import * as format from "./format";
import { whyOther } from "./parting";
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

/** Names of the runs of a page; of those without, their numbers. */
export function runNames(sources: RecordedSource[]): string[] {
  return sources.map(({ header }, i) => header.label ?? `run ${i + 1}`);
}

/** The names without their keys, where these are the same in all: "ratio, 0.5" for "method.toi=ratio, run.step=0.5". */
export function shortNames(names: string[]): string[] {
  const key = /[^\s,=]+=/g;
  const keysOf = (name: string) => (name.match(key) ?? []).join();
  return names.every((name) => keysOf(name) === keysOf(names[0])) ? names.map((name) => name.replace(key, "")) : names;
}

/** Colour of a run in the plots. */
export function runColor(run: number): string {
  return runColors[run % runColors.length];
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
