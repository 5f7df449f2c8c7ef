import { auditRows, auditText, auditWarnings, isSound } from "./audit_rows";
import { el } from "./dom";
import { runColor, runNames, shortNames } from "./run_names";
import type { RecordedSource } from "./source";

/** A line of the audits side by side: one value a run. */
export interface ComparedRow {
  name: string;
  /** Whether it says how the run was made, not what came of it. */
  isSetting: boolean;
  values: string[];
  /** For each run, whether its value is another than that of the first run. */
  differs: boolean[];
}

/** Every line of any of the audits, in the order in which they come. */
export function comparedRows(audits: Record<string, unknown>[]): ComparedRow[] {
  const all = audits.map((audit) => new Map(auditRows(audit).map(({ name, value }) => [name, value])));
  const names = [...new Set(all.flatMap((rows) => [...rows.keys()]))];
  return names.map((name) => {
    const values = all.map((rows) => rows.get(name));
    // Exact values are compared: what is shown has fewer digits.
    return { name, isSetting: isSetting(name), values: values.map(auditText), differs: values.map((value) => JSON.stringify(value) !== JSON.stringify(values[0])) };
  });
}

const isSetting = (name: string): boolean => /^(method: |rigor$|scene$|scheme_?\s?reason|duration$|step$)/.test(name);

function verdict({ header }: RecordedSource): HTMLElement {
  if (header.stopped) return el("td", { class: "broken" }, el("p", { text: `✗ stopped: ${header.stopped}` }));
  return isSound(header.audit) ? el("td", { class: "sound", text: "✓ audit passed" }) : el("td", { class: "broken", text: "✗ audit violated" });
}

/** The audits of all runs as one table; what is not as in the first run is marked. */
export function compareAudits(sources: RecordedSource[]): HTMLElement {
  const names = runNames(sources), short = shortNames(names);
  const audits = sources.map(({ header }) => header.audit);
  const head = el("tr", {}, el("td"), ...short.map((name, i) =>
    el("th", { scope: "col", title: names[i] }, el("span", { class: "dot", style: `background:${runColor(i)}` }), name)));
  const verdicts = el("tr", {}, el("th", { scope: "row", text: "ended" }), ...sources.map(verdict));
  const all = comparedRows(audits);
  const rowOf = ({ name, values, differs, isSetting }: ComparedRow) => {
    const isMarked = differs.includes(true);
    return el("tr", { class: [isMarked ? "" : "same", isSetting ? "setting" : ""].join(" ").trim() || undefined }, el("th", { scope: "row", text: isMarked ? `≠ ${name}` : name }),
      ...values.map((value, i) => el("td", { class: differs[i] ? "differs" : undefined, text: value })));
  };
  // What came of the runs first, then how they were made; settings that are equal are folded away.
  const outcomes = all.filter((row) => !row.isSetting), settings = all.filter((row) => row.isSetting);
  const equal = settings.filter(({ differs }) => !differs.includes(true)).length;
  const fold = el("button", { type: "button", class: "link", id: "equal-settings", "aria-expanded": "false", onclick: () => {
    const isFolded = body.classList.toggle("folded");
    fold.setAttribute("aria-expanded", String(!isFolded));
    fold.textContent = foldText(equal, isFolded);
  } }, foldText(equal, true));
  const heading = el("tr", { class: "group" }, el("th", { scope: "row" }, "Settings"), el("td", { colspan: audits.length }, equal > 0 ? fold : ""));
  const hasWarnings = audits.some((audit) => auditWarnings(audit).length > 0);
  const warnings = el("tr", {}, el("th", { scope: "row", text: "warnings" }), ...audits.map((audit) =>
    el("td", {}, ...auditWarnings(audit).map((warning) => el("p", { class: "warning", text: warning })))));
  const body = el("tbody", { class: "folded" }, verdicts, hasWarnings ? warnings : undefined, ...outcomes.map(rowOf), heading, ...settings.map(rowOf));
  const table = el("table", {}, el("thead", {}, head), body);
  const only = el("input", { type: "checkbox", id: "only-differences", onchange: () => table.classList.toggle("only", only.checked) });
  return el("section", { class: "audits" },
    el("h2", {}, "Audits", el("small", { text: " ≠: not the same in all runs; marked: other than in the first" })),
    el("label", {}, only, "only what differs"), el("div", { class: "wide", tabindex: 0, role: "region", "aria-label": "Audits side by side" }, table));
}

function foldText(count: number, isFolded: boolean): string {
  return `${isFolded ? "show" : "hide"} the ${count} that are the same in all runs`;
}
