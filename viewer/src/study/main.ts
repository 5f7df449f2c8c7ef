import { el } from "../dom";
import { ChosenRun } from "./chosen_run";
import { readStudy } from "./data";
import { ParallelPlot } from "./parallel";
import { ScatterPlot } from "./scatter";
import { Selection } from "./selection";
import style from "./study.css";

/** What can be chosen and replayed, at the place that the program has left for it. */
function start(): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(style);
  document.adoptedStyleSheets = [sheet];
  const data = document.getElementById("study-data"), place = document.getElementById("runs");
  if (!data || !place) return;
  const isServed = document.querySelector('meta[name="rigor-served"]') !== null;
  const study = readStudy(data.textContent ?? "", isServed ? new URLSearchParams(location.search).get("token") : null);
  if (study.columns.length === 0) return;
  const selection = new Selection(study);
  const shown = study.runs.length < study.total ? ` ${study.runs.length} of them, evenly, are on this page.` : "";
  const parallel = el("div", { class: "plot" }), scatter = el("div", { class: "plot" }), chosen = el("div", { class: "chosen" });
  place.append(el("h2", {}, "Runs"),
    el("p", { class: "hint" }, `A line is a run; outcomes are blue, and lines have the colour of ${study.columns[study.main].name}. Drag along an axis to keep a range, click a line or a dot to choose its run.${shown}`),
    parallel, el("div", { class: "beside" }, scatter, chosen));
  if (study.columns.length > 1) new ParallelPlot(parallel, study, selection);
  new ScatterPlot(scatter, study, selection);
  new ChosenRun(chosen, study, selection);
  Object.assign(window, { rigorStudy: { study, selection } });
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
