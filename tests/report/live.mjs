// Opens the page of a run that goes on (armtune tune --live), touches nothing, and sees it keep up. See scripts/check-report.
//   node live.mjs ARMTUNE FOLDER     FOLDER: as make-runs leaves it, with live.yaml
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { bringIntoView, end, launch, openPage } from "./browser.mjs";
import { plotted } from "./checks/drawn.mjs";

const [armtune, folder] = process.argv.slice(2);
const WATCHED_S = 10;
const PATIENCE_MS = 120_000;

const failed = [];
const expect = (holds, what) => {
  console.log(`  ${holds ? "ok  " : "FAIL"} ${what}`);
  if (!holds) failed.push(what);
};

async function until(holds, what) {
  for (const late = Date.now() + PATIENCE_MS; Date.now() < late; ) {
    if (await holds()) return;
    if (run.exitCode !== null && !interrupted) throw new Error(`${what}: the run ended with ${run.exitCode} before`);
    await new Promise((done) => setTimeout(done, 200));
  }
  throw new Error(`${what}: not within ${PATIENCE_MS / 1000} s`);
}

/** Of a page that may be loading itself again at this moment. */
const words = (page, selector) => page.locator(selector).textContent({ timeout: 5000 }).catch(() => "");
const evaluations = async (page) => Number(/^(\d+) of \d+ evaluations/.exec(await words(page, "#live p"))?.[1] ?? 0);

async function watch(page) {
  await until(async () => (await evaluations(page)) > 0, "the page says how many evaluations there are");
  const first = await evaluations(page);
  await until(async () => /about .* left/.test(await words(page, "#live p")), "the time left");
  await until(async () => (await words(page, "h1")).length > 0, "a verdict of the best so far");
  await until(() => page.evaluate(() => (window.first = true)).catch(() => false), "a mark on the page");
  await new Promise((done) => setTimeout(done, 1000 * WATCHED_S));
  await until(async () => (await evaluations(page)) > first, "more evaluations");
  expect((await page.evaluate(() => window.first)) === undefined, `the page has loaded itself again: ${await evaluations(page)} evaluations after ${first}`);
}

async function drawn(page) {
  for (const id of ["convergence", "front"]) {
    // Once more where the page loads itself again in the midst of looking.
    let plots = [];
    for (let tries = 0; tries < 5 && !(plots[0]?.strong > 20); ++tries) {
      await bringIntoView(page, `#${id}`).catch(() => {});
      plots = await plotted(page, `#${id} .plot`).catch(() => []);
    }
    expect(plots[0]?.strong > 20, `the plot of '${id}' shows marks while the run goes on`);
  }
}

const run = spawn(armtune, ["tune", "live.yaml", "--out", "live", "--live", "--no-analysis"], { cwd: folder, stdio: "ignore" });
let interrupted = false;
const ended = new Promise((done) => run.on("exit", (code) => done(code)));
const browser = await launch();
try {
  const file = join(folder, "live/report.html");
  await until(() => existsSync(file), "a first page");
  const { page, complaints } = await openPage(browser, pathToFileURL(file).href);
  await watch(page);
  await drawn(page);
  expect(run.exitCode === null, "the run still goes on");
  interrupted = true;
  run.kill("SIGINT");
  expect((await ended) === 130, "interrupted, it ends with 130");
  await until(async () => (await page.locator("#live").count().catch(() => 1)) === 0, "the ended run's own page");
  expect((await words(page, "h1")).length > 0, "the last page, loaded by itself, is that of the ended run");
  expect(complaints.length === 0, `the console stays empty${complaints.length ? `: ${complaints[0]}` : ""}`);
} catch (error) {
  expect(false, error.message.split("\n")[0]);
} finally {
  run.kill("SIGKILL");
  await end(browser);
}
process.exit(failed.length === 0 ? 0 : 1);
