// The same page with other data.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const DATA = /(<script id="report-data" type="application\/json">)([\s\S]*?)(<\/script>)/;

export function dataOf(file) {
  const found = DATA.exec(readFileSync(file, "utf8"));
  if (found === null) throw new Error(`${file}: no report data in it`);
  return JSON.parse(found[2]);
}

/** Scenarios that have a tab, in their order. */
export function tabsOf(data) {
  return data.scenarios.filter((scenario) => scenario.runs.length > 0);
}

/** Whether a tab opens with a replay: of its last run. */
export function hasReplay(data, scenario) {
  return data.robots[scenario.robot] !== undefined && scenario.runs.at(-1).replay.n > 0;
}

/** Writes the report with other data to the folder; returns its address. */
export function variant(file, data, folder, name) {
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  const changed = join(folder, name);
  writeFileSync(changed, readFileSync(file, "utf8").replace(DATA, (_, open, __, close) => open + json + close));
  return pathToFileURL(changed).href;
}
