// Bundles src/ into dist/template.html: one file with style and script inside and, where the data go, the
// placeholder. `node build.mjs OUT` writes to OUT instead.
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "dist", "template.html");
const placeholder = "<!--report-data-->";

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["es2020"],
    charset: "ascii",
    legalComments: "inline",
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

/** The licences of what is bundled ask to go along with every copy. */
async function notices() {
  const texts = ["three", "uplot"].map(async (name) => {
    const text = await readFile(join(here, "node_modules", name, "LICENSE"), "utf8");
    return `${name}\n${text.trim()}`;
  });
  return `/*!\n${(await Promise.all(texts)).join("\n\n").replaceAll("*/", "* /")}\n*/\n`;
}

const [template, script, style] = await Promise.all([
  readFile(join(here, "src", "template.html"), "utf8"),
  bundle("main.ts"),
  bundle("page.css"),
]);
// An end tag inside a string of the script would end the element.
const inert = (await notices()).concat(script).replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
const page = template
  .replace("/*style*/", () => style)
  .replace("/*script*/", () => inert);
if (page.split(placeholder).length !== 2) {
  throw new Error(`template.html: '${placeholder}' must stand in the page exactly once`);
}
await mkdir(dirname(out), { recursive: true });
await writeFile(out, page);
console.log(`${out}: ${(page.length / 1024).toFixed(0)} KiB`);
