import uPlotStyle from "uplot/dist/uPlot.min.css";
import style from "./style.css";

/** Gives the page its style sheets. They are made by the script: the page's policy allows none in its text. */
export function installStyle(): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(uPlotStyle + style);
  document.adoptedStyleSheets = [sheet];
}
