// The section about the origin of the results, with the command that repeats the run.
import type { ReportData } from "../data";
import { breakable, element } from "../dom";
import { section, type Section } from "./section";

export function provenanceSection(data: ReportData): Section {
  const command = element("code", {}, data.provenance.command);
  const copy = element("button", { type: "button" }, "Copy");
  copy.addEventListener("click", () => {
    const range = document.createRange();
    range.selectNodeContents(command);
    getSelection()?.removeAllRanges();
    getSelection()?.addRange(range);
    const done = () => (copy.textContent = "Copied");
    // If the page may not use the clipboard, the command stays selected for Ctrl-C.
    navigator.clipboard?.writeText(data.provenance.command).then(done, () => undefined);
  });
  const list = element("dl");
  for (const [name, value] of data.provenance.entries) {
    list.append(element("div", {}, element("dt", {}, breakable(name)), element("dd", {}, value)));
  }
  return section(
    "provenance",
    "Provenance",
    "Where this comes from",
    element("p", { class: "note" }, "This command repeats the run and is quoted for a shell. Start it in the folder where the run was started, because paths may be relative. A folder given by --out must be new:"),
    element("div", { class: "command" }, element("pre", { tabindex: 0 }, command), copy),
    list,
  );
}
