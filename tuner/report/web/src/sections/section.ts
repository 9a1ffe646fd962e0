// A section of the page: heading, anchor and content.
import { element, type Child } from "../dom";

export interface Section {
  id: string;
  /** Name in the table of contents. */
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
