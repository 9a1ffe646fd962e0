// Opens report pages from file:// and checks what a reader would see. See scripts/check-report.
import { mkdirSync, mkdtempSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { end, findBrowser, launch, NO_FRAME, openPage } from "./browser.mjs";
import { checkArm } from "./checks/arm.mjs";
import { checkCases } from "./checks/cases.mjs";
import { checkDrawn } from "./checks/drawn.mjs";
import { checkInert } from "./checks/inert.mjs";
import { checkKeyboard } from "./checks/keyboard.mjs";
import { checkPhone, checkThemes, takeScreenshots, verdictPainted } from "./checks/looks.mjs";
import { checkPlots, checkReplay } from "./checks/replay.mjs";
import { dataOf, hasReplay, tabsOf } from "./checks/variant.mjs";
import { Pictures } from "./pictures.mjs";

const LARGEST_MB = 6;
// Four times what a report takes on two busy processors.
const DEADLINE_S = 240;

async function withoutWebGl(address, data, expect) {
  const [first] = tabsOf(data);
  if (first === undefined || !hasReplay(data, first)) return;
  const browser = await launch({ webGl: false });
  try {
    const { page, complaints } = await openPage(browser, address);
    await page.evaluate(() => document.querySelector("#replay").scrollIntoView({ behavior: "instant" }));
    const words = await page.locator(".panel:not([hidden]) .no-webgl").textContent({ timeout: 5000 }).catch(() => null);
    expect(words?.includes("WebGL") === true, "without WebGL the page says so in the picture's place");
    const uncaught = complaints.filter((text) => text.startsWith("uncaught"));
    expect(uncaught.length === 0, `and everything else works${uncaught.length ? `: ${uncaught[0]}` : ""}`);
  } finally {
    await browser.close();
  }
}

async function checkReport(browser, file, out, { quiet, paintLimit }, attempt) {
  const failed = [];
  const times = [];
  let passed = 0;
  const expect = (holds, what) => {
    if (holds) ++passed;
    else failed.push(what);
    if ((!holds || !quiet) && !attempt.givenUp) console.log(`  ${holds ? "ok  " : "FAIL"} ${what}`);
  };
  const part = async (name, run) => {
    const started = Date.now();
    try {
      await run();
    } catch (error) {
      if (error.message.includes(NO_FRAME)) throw error;
      expect(false, `${name}: ${error.message.split("\n")[0]}`);
    }
    times.push(`${name} ${((Date.now() - started) / 1000).toFixed(1)} s`);
  };
  if (out !== null) mkdirSync(out, { recursive: true });
  const folder = mkdtempSync(join(tmpdir(), "armtune-check-report-"));
  const address = pathToFileURL(file).href;
  const data = dataOf(file);
  const pictures = await Pictures.make(browser);
  try {
    // What the browser needs for its own first page is not the report's.
    await (await openPage(browser, "data:text/html,<p>warm")).context.close();
    const size = statSync(file).size / 1e6;
    expect(size <= LARGEST_MB, `${size.toFixed(2)} MB, at most ${LARGEST_MB}`);
    const { page, context, requests, complaints } = await openPage(browser, address);
    const paint = await verdictPainted(page);
    expect(paint !== null, "the verdict is painted");
    // Without a limit said, not judged: it is a figure of the machine and of what else runs on it.
    if (paintLimit === null) console.log(`  the verdict is painted after ${paint?.toFixed(0)} ms`);
    else expect(paint !== null && paint <= paintLimit, `the verdict is painted after ${paint?.toFixed(0)} ms, at most ${paintLimit}`);
    const all = { browser, page, data, address, file, folder, out, expect, pictures };
    await part("drawn", () => checkDrawn(all));
    // A validation or a calibration has no rollouts, and so no replay and no time that its plots share.
    const moves = tabsOf(data).length > 0;
    if (moves) await part("replay", () => checkReplay(all));
    if (moves) await part("plots", () => checkPlots(all));
    await part("themes", () => checkThemes(all));
    if (moves) await part("keyboard", () => checkKeyboard(all));
    const own = requests.filter((one) => one !== address && !one.startsWith("blob:") && !one.startsWith("data:"));
    expect(requests[0] === address && own.length === 0, `no request but the file itself${own.length ? `: ${own[0]}` : ""}`);
    expect((await page.evaluate(() => window.ran)) === undefined, "no name of the run's own files ran");
    expect(complaints.length === 0, `the console stays empty${complaints.length ? `: ${complaints[0]}` : ""}`);
    await context.close();
    if (moves) await part("arm", () => checkArm(all));
    await part("phone", () => checkPhone(all));
    await part("markup", () => checkInert(all));
    if (moves) await part("cases", () => checkCases(all));
    await part("without WebGL", () => withoutWebGl(address, data, expect));
    if (out !== null) await part("screenshots", () => takeScreenshots(all));
    if (!quiet) console.log(`  ${times.join(", ")}`);
  } finally {
    rmSync(folder, { recursive: true });
  }
  return { passed, failed };
}

/** The same, in a browser of its own. One that stops answering, or drawing, is no fault of the report: a second one is
 * asked. */
async function checkReportInTime(file, out, options) {
  for (let number = 1; ; ++number) {
    const browser = await launch();
    const attempt = { givenUp: false };
    let late;
    let what;
    const deadline = new Promise((_, fail) => {
      late = setTimeout(() => fail(new Error(`the browser has not answered for ${DEADLINE_S} s`)), 1000 * DEADLINE_S);
    });
    const checks = checkReport(browser, file, out, options, attempt);
    checks.catch(() => {});  // what it throws once its browser has gone, nobody hears
    try {
      return await Promise.race([checks, deadline]);
    } catch (error) {
      attempt.givenUp = true;
      [what] = error.message.split("\n");
    } finally {
      clearTimeout(late);
      await end(browser);
    }
    console.log(`  ${number === 2 ? "FAIL " : ""}${what}${number === 1 ? ": once more in a new one" : ""}`);
    if (number === 2) return { passed: 0, failed: [what] };
  }
}

const options = { out: null, quiet: false, paintLimit: null, folders: [] };
for (let i = 2; i < process.argv.length; ++i) {
  const argument = process.argv[i];
  if (argument === "--out") options.out = process.argv[++i];
  else if (argument === "--paint-limit") options.paintLimit = Number(process.argv[++i]);
  else if (argument === "--quiet") options.quiet = true;
  else options.folders.push(argument);
}
const from = process.env.CHECK_REPORT_FROM ?? process.cwd();
console.log(`browser: ${findBrowser()}`);
let failures = 0;
for (const [i, folder] of options.folders.entries()) {
  const place = resolve(from, folder);
  const file = place.endsWith(".html") ? place : join(place, "report.html");
  console.log(`${folder}`);
  const out = options.out === null ? null : resolve(from, options.out, `${i + 1}-${basename(place)}`);
  const { passed, failed } = await checkReportInTime(file, out, options);
  console.log(`  ${passed} checks passed, ${failed.length} failed`);
  failures += failed.length;
}
// At once, whatever a browser that was given up still holds open.
process.exit(failures === 0 ? 0 : 1);
