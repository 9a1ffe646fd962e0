// A patch of colour in a legend. It changes when the page switches between light and dark colours.
import { element } from "../dom";
import { onTheme } from "../theme";

export function swatch(colour: () => string, kind = ""): HTMLElement {
  const made = element("span", { class: `swatch ${kind}`.trim(), "aria-hidden": true });
  const paint = () => made.style.setProperty("--colour", colour());
  onTheme(paint);
  paint();
  return made;
}
