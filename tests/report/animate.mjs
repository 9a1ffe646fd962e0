// Takes pictures of a replay at equal steps of its time. See scripts/animate-replay.
//   node animate.mjs REPORT.HTML FOLDER TAB FROM TO FRAMES
// REPORT.HTML is the page, FOLDER where frame_NNN.png are written, TAB the scenario's tab from 0, FROM and TO times in s.
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { bringIntoView, end, launch, openPage, settle } from "./browser.mjs";

const [report, out, ...numbers] = process.argv.slice(2);
const [tab, from, to, frames] = numbers.map(Number);
const SIZE = { width: 700, height: 640 };
const CLOSER = -350; // px of the mouse's wheel

const browser = await launch();
try {
  const { page } = await openPage(browser, pathToFileURL(resolve(report)).href, { colorScheme: "dark", viewport: SIZE });
  await page.locator(`#tab-${tab}`).click();
  await bringIntoView(page, ".panel:not([hidden]) .stage");
  await settle(page, 600);
  const stage = page.locator(".panel:not([hidden]) .stage");
  const box = await stage.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, CLOSER);
  const scrub = page.locator(".panel:not([hidden]) .scrub");
  const longest = Number(await scrub.getAttribute("max"));
  if (!(from < to && to <= longest)) throw new Error(`the replay lasts ${longest} s; ${from} to ${to} s are not within it`);
  for (let i = 0; i < frames; ++i) {
    await scrub.evaluate((slider, time) => {
      slider.value = time;
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    }, from + ((to - from) * i) / frames);
    await settle(page, 50);
    await stage.screenshot({ path: join(out, `frame_${String(i).padStart(3, "0")}.png`) });
  }
} finally {
  await end(browser);
}
