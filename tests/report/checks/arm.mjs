// The arm itself is in the picture, and moves: not floor, target, trail or obstacles in its place.
import { bringIntoView, openPage, settle } from "../browser.mjs";
import { passes, seconds, STAGE, stepScale } from "./replay.mjs";
import { hasReplay, tabsOf, variant } from "./variant.mjs";

/** Portion of the picture; an arm takes several percent of it, its shadow as much. */
const SEEN = 0.01;
const MOVED = 0.001;

/** Nothing but the arm of the last run can move: no target, no obstacles, a tool path of one point. */
function bareOf(data) {
  const bare = structuredClone(data);
  for (const scenario of bare.scenarios) {
    scenario.obstacles = [];
    scenario.runs = scenario.runs.slice(-1);
    for (const { replay } of scenario.runs) {
      replay.target = [];
      replay.obstacles = [];
      for (const series of replay.tool) series.hi = series.lo;
    }
  }
  return bare;
}

/** Opens a tab; its stage as it stands, without the words laid over it. */
async function stageOf(page, tab) {
  await page.addStyleTag({ content: ".state, .over-now { visibility: hidden; }" });
  await page.locator(`#tab-${tab}`).click();
  await bringIntoView(page, "#replay");
  await page.locator(STAGE).waitFor();
  await settle(page, 100);
  return page.locator(STAGE).screenshot();
}

export async function checkArm({ browser, file, folder, data, expect, pictures }) {
  const tabs = [...tabsOf(data).entries()].filter(([, scenario]) => hasReplay(data, scenario)).map(([i]) => i);
  if (tabs.length === 0) return;
  const bare = bareOf(data);
  const without = structuredClone(bare);
  for (const robot of without.robots) robot.shapes = [];
  const opened = await openPage(browser, variant(file, without, folder, "armless.html"));
  const empty = new Map();
  for (const i of tabs) empty.set(i, await stageOf(opened.page, i));
  await opened.context.close();
  const { page, context } = await openPage(browser, variant(file, bare, folder, "arm.html"));
  for (const i of tabs) {
    const before = await stageOf(page, i);
    const seen = await pictures.difference(empty.get(i), before);
    expect(seen > SEEN, `scenario ${i + 1}: the arm is in the picture (${(100 * seen).toFixed(1)} % of it)`);
    const [started, play] = [await seconds(page), page.locator(".panel:not([hidden]) .play")];
    await play.click();
    await passes(page, started + 0.5 * (await stepScale(page)));
    await play.click();
    await settle(page, 50);
    const moved = await pictures.difference(before, await page.locator(STAGE).screenshot());
    expect(moved > MOVED, `scenario ${i + 1}: play moves the arm itself (${(100 * moved).toFixed(2)} % of the pixels, all else at rest)`);
  }
  await context.close();
}
