// Saves drawings as files. The files are made in the page, and nothing is sent.
import { element, svg } from "./dom";
import { drawMark, type Shape } from "./plots/marks";
import { cssColor } from "./theme";

function save(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

export function savePng(canvas: HTMLCanvasElement, name: string): void {
  canvas.toBlob((content) => {
    if (content !== null) save(content, `${name}.png`);
  }, "image/png");
}

export interface LegendEntry {
  label: string;
  colour: string;
  faint?: boolean;
  /** Shape, if the entry is drawn with marks; otherwise it is a line. */
  mark?: Shape | undefined;
}

/** Returns the plot with the title above and the legend below it, on the colour of the page. */
export function framedCanvas(plot: HTMLCanvasElement, title: string, legend: LegendEntry[]): HTMLCanvasElement {
  const scale = devicePixelRatio;
  const margin = 12 * scale;
  const line = 18 * scale;
  const framed = document.createElement("canvas");
  const probe = framed.getContext("2d");
  if (probe === null) return plot;
  const font = (weight: string, size: number) => `${weight} ${size * scale}px system-ui, sans-serif`;
  probe.font = font("400", 12);
  const width = plot.width + 2 * margin;
  const places: { entry: LegendEntry; x: number; row: number }[] = [];
  let x = margin;
  let row = 0;
  for (const entry of legend) {
    const needed = probe.measureText(entry.label).width + 34 * scale;
    if (x > margin && x + needed > width - margin) {
      x = margin;
      ++row;
    }
    places.push({ entry, x, row });
    x += needed;
  }
  const top = margin + 1.6 * line;
  framed.width = width;
  framed.height = top + plot.height + (legend.length > 0 ? (row + 1.4) * line : 0) + margin;
  probe.fillStyle = cssColor("page");
  probe.fillRect(0, 0, framed.width, framed.height);
  probe.fillStyle = cssColor("ink");
  probe.font = font("600", 14);
  probe.fillText(title, margin, margin + line * 0.8);
  probe.drawImage(plot, margin, top);
  probe.font = font("400", 12);
  for (const place of places) {
    const y = top + plot.height + (place.row + 1) * line;
    probe.globalAlpha = place.entry.faint === true ? 0.5 : 1;
    probe.fillStyle = place.entry.colour;
    if (place.entry.mark === undefined) probe.fillRect(place.x, y - 5 * scale, 16 * scale, 3 * scale);
    else drawMark(probe, place.entry.mark, place.x + 8 * scale, y - 4 * scale, 10 * scale, place.entry.colour);
    probe.globalAlpha = 1;
    probe.fillStyle = cssColor("ink");
    probe.fillText(place.entry.label, place.x + 21 * scale, y);
  }
  return framed;
}

/** Returns a copy of the drawing with title, margin and its present colours, because a saved file does not
 * have the style sheet of the page. */
function standalone(drawing: SVGSVGElement): SVGSVGElement {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const from = drawing.querySelectorAll("*");
  copy.querySelectorAll("*").forEach((node, i) => {
    const original = from[i];
    if (original === undefined) return;
    const style = getComputedStyle(original);
    for (const name of ["fill", "stroke", "stroke-width", "stroke-dasharray", "font-size", "font-weight", "opacity"]) {
      node.setAttribute(name, style.getPropertyValue(name));
    }
    node.removeAttribute("class");
  });
  const { width, height } = drawing.viewBox.baseVal;
  const [margin, head] = [14, 40];
  const title = svg("text", { x: 0, y: -16, "font-size": 15, "font-weight": 600, fill: cssColor("ink") });
  title.textContent = drawing.getAttribute("aria-label");
  copy.append(title);
  copy.setAttribute("viewBox", `${-margin} ${-head} ${width + 2 * margin} ${height + head + margin}`);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(width + 2 * margin));
  copy.setAttribute("height", String(height + head + margin));
  copy.setAttribute("style", `background:${cssColor("page")};font-family:system-ui,sans-serif`);
  return copy;
}

export function saveSvg(drawing: SVGSVGElement, name: string): void {
  const text = new XMLSerializer().serializeToString(standalone(drawing));
  save(new Blob([text], { type: "image/svg+xml" }), `${name}.svg`);
}

export function saveSvgAsPng(drawing: SVGSVGElement, name: string): void {
  const copy = standalone(drawing);
  const box = copy.viewBox.baseVal;
  const scale = Math.max(2, devicePixelRatio);
  const image = new Image();
  image.onload = () => {
    const canvas = document.createElement("canvas");
    canvas.width = box.width * scale;
    canvas.height = box.height * scale;
    const context = canvas.getContext("2d");
    if (context === null) return;
    context.fillStyle = cssColor("page");
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    savePng(canvas, name);
  };
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
}

export function saveButtons(what: string, saves: { label: string; save: () => void }[]): HTMLElement {
  const group = element("span", { class: "saves" });
  for (const { label, save: run } of saves) {
    group.append(
      element("button", { type: "button", class: "save", "aria-label": `Save ${what} as ${label}`, onclick: run }, label),
    );
  }
  return group;
}
