// Elements from code. Text becomes text nodes only: nothing here parses markup, so a name that holds some is
// shown as it is.

export type Child = Node | string | null | undefined | false;
type Value = string | number | boolean | undefined | ((event: never) => void);

/** Attributes: `onclick` and the like are listeners, true and false set and leave out, the rest is text. */
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

/** The text, with leave to break after every /, _ and point. */
export function breakable(text: string): HTMLElement {
  const made = element("span");
  for (const part of text.match(/[^/_.]+[/_.]*|[/_.]+/g) ?? []) made.append(part, element("wbr"));
  return made;
}

/** A button that stays in or out; `changed` hears what it is now. */
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
