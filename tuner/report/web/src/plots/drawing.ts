// A plot drawn as SVG. It is drawn again for every width, so that its text keeps its size on a phone.
import { element, svg } from "../dom";
import { saveButtons, saveSvg, saveSvgAsPng } from "../export";

export interface DrawingOptions {
  title: string;
  file: string;
  /** Draws the content for a width; returns the height that it needs [px]. */
  draw: (into: SVGSVGElement, width: number) => number;
}

export function drawing(options: DrawingOptions): HTMLElement {
  const place = element("div", { class: "drawing" });
  let current: SVGSVGElement | null = null;
  let width = 0;
  const redraw = () => {
    const now = Math.floor(place.clientWidth);
    if (now <= 0 || now === width) return;
    width = now;
    const picture = svg("svg", { role: "img", "aria-label": options.title });
    const height = options.draw(picture, width);
    picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    picture.setAttribute("width", String(width));
    picture.setAttribute("height", String(height));
    current = picture;
    place.replaceChildren(picture);
  };
  new ResizeObserver(redraw).observe(place);
  const withPicture = (save: (picture: SVGSVGElement, name: string) => void) => () => {
    if (current !== null) save(current, options.file);
  };
  return element(
    "figure",
    { class: "plot" },
    element(
      "figcaption",
      {},
      element("span", { class: "plot-title" }, options.title),
      saveButtons(options.title, [
        { label: "SVG", save: withPicture(saveSvg) },
        { label: "PNG", save: withPicture(saveSvgAsPng) },
      ]),
    ),
    place,
  );
}

export function label(
  x: number,
  y: number,
  text: string,
  anchor: "start" | "middle" | "end" = "start",
  kind = "",
): SVGTextElement {
  return svg("text", { x, y, "text-anchor": anchor, class: `label ${kind}`, "font-size": 12 }, text);
}

/** Returns the text, or an ellipsis and its end if it does not fit into the width [px]. */
export function fitted(text: string, width: number): string {
  const most = Math.max(4, Math.floor(width / 6.6));
  return text.length <= most ? text : `…${text.slice(text.length - most + 1)}`;
}
