import { App } from "./app";
import { DataError, findBlocks } from "./blocks";
import { el } from "./dom";
import { LiveApp } from "./live_app";
import { loadRuns } from "./run";
import { installStyle } from "./style";

/** Reads the page's data and shows them, or says in words why that cannot be. */
async function start(): Promise<void> {
  installStyle();
  const progress = el("progress", { max: 1, value: 0 });
  const waiting = el("main", { class: "message", id: "message", role: "status" }, el("p", { text: "Reading the simulation …" }), progress);
  document.body.append(waiting);
  try {
    const expected = Number(document.querySelector<HTMLMetaElement>('meta[name="rigor-blocks"]')?.content ?? 0);
    const loaded = await loadRuns(findBlocks(document), expected, (part) => (progress.value = part));
    waiting.remove();
    const mark = document.querySelector<HTMLMetaElement>('meta[name="rigor-live"]');
    const app = mark ? new LiveApp(loaded.runs[0], Number(mark.content)) : new App(loaded);
    document.body.append(app.element);
    app.begin();
    Object.assign(window, { rigor: app });
  } catch (error) {
    if (!(error instanceof DataError)) console.error(error);
    waiting.replaceChildren(
      el("h1", { text: "This page cannot be shown" }),
      el("p", { text: error instanceof Error ? `${error.message}.` : String(error) }),
      el("p", { text: "The file was probably cut or changed on its way. Write it again with: rigor run SCENE -o page.html" }));
    document.body.append(waiting);
  }
}

document.addEventListener("DOMContentLoaded", () => void start());
