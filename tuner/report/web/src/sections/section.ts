// A part of the page: heading, anchor, content.
import { element, type Child } from "../dom";

export interface Section {
  id: string;
  /** In the list of contents. */
  short: string;
  root: HTMLElement;
}

export function section(id: string, short: string, heading: string, ...content: Child[]): Section {
  const root = element(
    "section",
    { id, "aria-labelledby": `${id}-heading` },
    element("h2", { id: `${id}-heading` }, heading),
    ...content,
  );
  return { id, short, root };
}
