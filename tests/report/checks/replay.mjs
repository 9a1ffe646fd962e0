// The replay moves the arm; its time and the plots' are one.
import { bringIntoView, settle } from "../browser.mjs";
import { hasReplay, tabsOf } from "./variant.mjs";

const CLOCK = ".panel:not([hidden]) .clock";
export const STAGE = ".panel:not([hidden]) .stage canvas";
const PLOT = ".panel:not([hidden]) .plot";

export const seconds = async (page) => parseFloat((await page.textContent(CLOCK)) ?? "");

/** Below 1 where all is over within seconds: there keys step less far. */
export const stepScale = async (page) => Math.min(1, (await page.evaluate(() => Number(document.querySelector(".panel:not([hidden]) .scrub").max))) / 5);

/** x of the playhead in the first plot, px. */
async function playhead(page) {
  return page.evaluate((plot) => {
    const line = document.querySelector(`${plot} .playhead`);
    return line.getBoundingClientRect().left - line.parentElement.getBoundingClientRect().left;
  }, PLOT);
}

/** Waits until the clock is beyond a time; a slow machine shows few frames, but some. */
export async function passes(page, time) {
  const beyond = ([clock, than]) => parseFloat(document.querySelector(clock).textContent) > than;
  return page.waitForFunction(beyond, [CLOCK, time], { timeout: 15000 }).then(
    () => true,
    () => false,
  );
}

export async function checkReplay({ page, data, expect, pictures }) {
  const [first] = tabsOf(data);
  if (first === undefined || !hasReplay(data, first)) return;
  await page.locator("#tab-0").click();
  await bringIntoView(page, "#replay");
  await settle(page, 200);
  const box = await page.locator(`${PLOT} .u-over`).first().boundingBox();

  const slider = await page.locator(".panel:not([hidden]) .scrub").boundingBox();
  await page.mouse.click(slider.x + 0.2 * slider.width, slider.y + slider.height / 2);
  await settle(page, 50);
  const [early, lineEarly] = [await seconds(page), await playhead(page)];
  const unmoved = await page.locator(STAGE).screenshot();
  await page.mouse.click(slider.x + 0.7 * slider.width, slider.y + slider.height / 2);
  await settle(page, 50);
  const [late, lineLate] = [await seconds(page), await playhead(page)];
  expect(late > early, `the slider moves the time (${early} to ${late} s)`);
  const expected = ((late - early) / (lineLate - lineEarly)) * box.width;
  const duration = await page.evaluate(() => Number(document.querySelector(".panel:not([hidden]) .scrub").max));
  expect(Math.abs(expected - duration) < 0.02 * duration, `the plots' cursor follows it (${lineEarly.toFixed(0)} to ${lineLate.toFixed(0)} px)`);
  expect((await pictures.difference(unmoved, await page.locator(STAGE).screenshot())) > 0.002, "and so does the picture");

  await page.mouse.move(box.x + 0.3 * box.width, box.y + box.height / 2);
  await settle(page, 50);
  const pointed = await seconds(page);
  expect(Math.abs(pointed - 0.3 * duration) < 0.02 * duration, `pointing into a plot moves the replay (to ${pointed} s)`);

  await page.mouse.move(4, 4);
  const before = await page.locator(STAGE).screenshot();
  const started = await seconds(page);
  await page.locator(".panel:not([hidden]) .play").click();
  expect(await passes(page, started + 0.5 * (await stepScale(page))), "play lets time pass");
  await page.locator(".panel:not([hidden]) .play").click();
  await settle(page, 50);
  const stopped = await seconds(page);
  const moved = await pictures.difference(before, await page.locator(STAGE).screenshot());
  expect(moved > 0.001, `and moves the picture (${(100 * moved).toFixed(2)} % of the pixels)`);
  await settle(page, 300);
  expect((await seconds(page)) === stopped, "pause holds it");

  const canvas = await page.locator(STAGE).boundingBox();
  const unturned = await page.locator(STAGE).screenshot();
  await page.mouse.move(canvas.x + canvas.width / 2, canvas.y + canvas.height / 2);
  await page.mouse.down();
  await page.mouse.move(canvas.x + canvas.width / 2 + 120, canvas.y + canvas.height / 2 + 20, { steps: 6 });
  await page.mouse.up();
  await settle(page, 50);
  expect((await pictures.difference(unturned, await page.locator(STAGE).screenshot())) > 0.02, "the mouse turns the view");
  const mouse = await page.locator(STAGE).screenshot();
  await page.locator(STAGE).focus();
  for (let i = 0; i < 4; ++i) await page.keyboard.press("Shift+ArrowLeft");
  await settle(page, 50);
  expect((await pictures.difference(mouse, await page.locator(STAGE).screenshot())) > 0.02, "and so do Shift and arrows");
}

/** Range of the time axis from its first and last label. */
async function zoomRange(page, index) {
  return page.evaluate(
    ([plot, i]) => document.querySelectorAll(plot)[i].dataset.from + " " + document.querySelectorAll(plot)[i].dataset.to,
    [PLOT, index],
  );
}

export async function checkPlots({ page, data, expect, pictures }) {
  const [first] = tabsOf(data);
  if (first === undefined) return;
  await page.locator("#tab-0").click();
  await bringIntoView(page, ".panel:not([hidden]) .right");
  await settle(page, 100);
  const over = page.locator(`${PLOT} .u-over`);
  const box = await over.first().boundingBox();
  const full = [await zoomRange(page, 0), await zoomRange(page, 1)];
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 40, { steps: 5 });
  await page.mouse.up();
  await settle(page, 50);
  const zoomed = [await zoomRange(page, 0), await zoomRange(page, 1)];
  expect(zoomed[0] !== full[0] && zoomed[0] === zoomed[1], `a drag zooms all plots (${zoomed[0]} s)`);
  await page.mouse.dblclick(box.x + 0.5 * box.width, box.y + 30);
  await settle(page, 50);
  expect((await zoomRange(page, 0)) === full[0] && (await zoomRange(page, 1)) === full[1], "a double click shows all again");

  await page.locator(PLOT).first().focus();
  await page.keyboard.press("+");
  await settle(page, 50);
  const keyed = [await zoomRange(page, 0), await zoomRange(page, 1)];
  expect(keyed[0] !== full[0] && keyed[0] === keyed[1], "plus zooms a plot that has the focus, and all others");
  await page.keyboard.press("0");
  await settle(page, 50);
  expect((await zoomRange(page, 0)) === full[0], "zero shows all again");

  const plot = page.locator(PLOT).first();
  const shown = await plot.locator(".canvas").screenshot();
  const entry = plot.locator(".legend button").first();
  await entry.click();
  await settle(page, 50);
  expect((await pictures.difference(shown, await plot.locator(".canvas").screenshot())) > 0, "a click in the legend hides its line");
  await entry.click();
  await page.mouse.move(4, 4);

  for (const [name, where] of [
    ["a plot", plot.locator(".save").first()],
    ...(hasReplay(data, first) ? [["the 3D picture", page.locator(".panel:not([hidden]) .replay .save")]] : []),
  ]) {
    const [download] = await Promise.all([page.waitForEvent("download"), where.click()]);
    const chunks = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk);
    const content = Buffer.concat(chunks);
    const png = content.subarray(1, 4).toString() === "PNG";
    expect(png && (await pictures.drawn(content)) > 0.01, `${name} is saved as PNG (${download.suggestedFilename()})`);
  }
}
