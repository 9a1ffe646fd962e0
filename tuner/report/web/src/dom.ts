// Makes HTML and SVG elements. Text only becomes text nodes and is never parsed, so HTML in a name is shown
// literally.

export type Child = Node | string | null | undefined | false;
type Value = string | number | boolean | undefined | ((event: never) => void);

/** Makes an HTML element. Attributes: a function, such as that of `onclick`, becomes a listener; true sets an
 * attribute, false leaves it out; all others are text. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, Value> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  setAttributes(made, attributes);
  append(made, children);
  return made;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Record<string, Value> = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  setAttributes(made, attributes);
  append(made, children);
  return made;
}

function setAttributes(made: Element, attributes: Record<string, Value>): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === "function") {
      made.addEventListener(name.slice(2), value as EventListener);
    } else {
      made.setAttribute(name, value === true ? "" : String(value));
    }
  }
}

function append(parent: Element, children: Child[]): void {
  for (const child of children) {
    if (child !== null && child !== undefined && child !== false) parent.append(child);
  }
}

/** Returns the text so that a line can break after every /, _ and point. */
export function breakable(text: string): HTMLElement {
  const made = element("span");
  for (const part of text.match(/[^/_.]+[/_.]*|[/_.]+/g) ?? []) made.append(part, element("wbr"));
  return made;
}

/** Returns a button that is pressed or not. Each click calls `changed` with the new state. */
export function toggle(
  label: string,
  pressed: boolean,
  changed: (pressed: boolean) => void,
  attributes: Record<string, Value> = {},
): HTMLButtonElement {
  const button = element("button", { type: "button", "aria-pressed": String(pressed), ...attributes }, label);
  button.addEventListener("click", () => {
    const now = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(now));
    changed(now);
  });
  return button;
}
