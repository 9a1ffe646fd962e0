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

/** Writes the report with other data to the folder; returns its address. */
export function variant(file, data, folder, name) {
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  const changed = join(folder, name);
  writeFileSync(changed, readFileSync(file, "utf8").replace(DATA, (_, open, __, close) => open + json + close));
  return pathToFileURL(changed).href;
}
