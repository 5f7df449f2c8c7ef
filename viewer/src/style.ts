import uPlotStyle from "uplot/dist/uPlot.min.css";
import style from "./style.css";

/** Puts the style sheets into the page. */
export function installStyle(): void {
  const sheet = document.createElement("style");
  sheet.textContent = uPlotStyle + style;
  document.head.append(sheet);
}
