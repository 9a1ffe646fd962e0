// All that a mouse can do, keys can.
import { bringIntoView, settle } from "../browser.mjs";
import { passes, stepScale } from "./replay.mjs";
import { hasReplay, tabsOf } from "./variant.mjs";

/** Tab from the top of the page on; what got the focus, and whether it showed. */
async function tabStops(page) {
  await page.evaluate(() => {
    window.scrollTo({ top: 0, behavior: "instant" });
    // The Tab key goes on from the last click: bring that to the top as well.
    document.body.tabIndex = -1;
    document.body.focus();
    document.body.removeAttribute("tabindex");
    window.stops = [];
    window.left = false;
    addEventListener("focusout", (event) => {
      if (event.relatedTarget === null && window.stops.length > 0) window.left = true;
    });
    addEventListener("focusin", ({ target }) => {
      if (window.left) return;
      const style = getComputedStyle(target);
      window.stops.push({
        name: [target.tagName.toLowerCase(), target.id ? `#${target.id}` : "", ...[...target.classList].map((c) => `.${c}`)].join(""),
        visible: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2,
      });
    });
  });
  for (let i = 0; i < 400; ++i) {
    await page.keyboard.press("Tab");
    if (i % 10 === 9 && (await page.evaluate(() => window.left))) break;
  }
  return page.evaluate(() => window.stops);
}

export async function checkKeyboard({ page, expect, data }) {
  const stops = await tabStops(page);
  const unseen = stops.filter((stop) => !stop.visible).map((stop) => stop.name);
  expect(unseen.length === 0, `focus shows on all ${stops.length} stops of the Tab key${unseen.length > 0 ? `, but not on ${unseen[0]}` : ""}`);
  const reached = (part) => stops.some((stop) => stop.name.includes(part));
  expect(reached("#theme"), "Tab reaches the colours' button");
  const [first] = tabsOf(data);
  if (first === undefined) return;
  const steered = hasReplay(data, first);
  for (const part of ["#tab-0", ...(steered ? ["canvas", ".play", ".scrub", "select"] : []), "figure.plot", ".entry", ".save"]) {
    expect(reached(part), `Tab reaches ${part}`);
  }
  if (!steered) return;
  await bringIntoView(page, "#replay");
  await page.evaluate(() => document.activeElement?.blur());
  const clock = async () => parseFloat((await page.textContent(".panel:not([hidden]) .clock")) ?? "");
  const begin = await clock();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  const right = await clock();
  expect(Math.abs(right - begin - 0.2 * (await stepScale(page))) < 0.011, "arrows move the time");
  await page.keyboard.press("ArrowLeft");
  expect((await clock()) < right, "and back");
  await page.keyboard.press(" ");
  expect(await passes(page, right), "space plays");
  await page.keyboard.press(" ");
  await settle(page);
  const held = await clock();
  await settle(page, 300);
  expect((await clock()) === held, "and pauses");
  if ((await page.locator("[role=tab]").count()) > 1) {
    await page.locator("#tab-0").focus();
    await page.keyboard.press("ArrowRight");
    expect((await page.getAttribute("#tab-1", "aria-selected")) === "true", "arrows choose a scenario");
    await page.keyboard.press("ArrowLeft");
  }
}
