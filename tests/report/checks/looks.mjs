// Widths, colours, when the verdict is painted; and pictures of all that for eyes.
import { join } from "node:path";
import { bringIntoView, openPage, settle, walkThrough } from "../browser.mjs";
import { hasReplay, tabsOf } from "./variant.mjs";

/** ms from opening the page until its verdict is on the screen; null where the browser does not say. */
export async function verdictPainted(page) {
  return page.evaluate(
    () =>
      new Promise((done) => {
        setTimeout(() => done(null), 10000);
        new PerformanceObserver((list) => {
          for (const entry of list.getEntries()) if (entry.identifier === "verdict") done(entry.renderTime || entry.loadTime);
        }).observe({ type: "element", buffered: true });
      }),
  );
}

const background = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

export async function checkThemes({ page, expect }) {
  await page.emulateMedia({ colorScheme: "light" });
  const light = await background(page);
  await page.emulateMedia({ colorScheme: "dark" });
  const dark = await background(page);
  expect(light !== dark, `light and dark follow the system (${light}, ${dark})`);
  await page.click("#theme");
  expect((await background(page)) === light, "the button turns dark to light");
  await page.click("#theme");
  expect((await background(page)) === dark, "and back");
  await page.emulateMedia({ colorScheme: "light" });
}

export async function checkPhone({ browser, address, data, expect, out }) {
  const { page, context, complaints } = await openPage(browser, address, {
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    deviceScaleFactor: 2,
  });
  if (out !== null) await page.screenshot({ path: join(out, "phone-top.png") });
  await walkThrough(page);
  const tabs = await page.locator("[role=tab]").count();
  for (let i = 0; i < Math.max(tabs, 1); ++i) {
    if (i > 0) {
      await page.locator(`#tab-${i}`).click();
      await walkThrough(page, "#replay");
    }
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(width <= 390, `no sideways scrolling at 390 px${tabs > 0 ? `, scenario ${i + 1}` : ""} (${width} px)`);
  }
  if (tabs > 0) {
    if (out !== null) {
      await bringIntoView(page, "#replay");
      await settle(page, 500);
      await page.screenshot({ path: join(out, "phone-replay.png") });
    }
    const over = page.locator(".panel:not([hidden]) .u-over").first();
    await over.scrollIntoViewIfNeeded();
    const box = await over.boundingBox();
    const line = () => page.evaluate(() => document.querySelector(".panel:not([hidden]) .playhead").style.transform);
    const before = await line();
    await page.touchscreen.tap(box.x + 0.8 * box.width, box.y + box.height / 2);
    await settle(page, 50);
    expect((await line()) !== before, "a touch in a plot moves the time");
    if (hasReplay(data, tabsOf(data)[tabs - 1])) {
      const clock = parseFloat(await page.textContent(".panel:not([hidden]) .clock"));
      const duration = await page.evaluate(() => Number(document.querySelector(".panel:not([hidden]) .scrub").max));
      expect(Math.abs(clock - 0.8 * duration) < 0.02 * duration, `and the replay's (to ${clock} s)`);
    }
  }
  expect(complaints.length === 0, `nothing to complain about on a phone${complaints.length ? `: ${complaints[0]}` : ""}`);
  await context.close();
}

export async function takeScreenshots({ browser, address, out, data }) {
  for (const colorScheme of ["light", "dark"]) {
    const { page, context } = await openPage(browser, address, { colorScheme });
    await settle(page, 300);
    await page.screenshot({ path: join(out, `${colorScheme}-top.png`) });
    for (let i = 0; i < tabsOf(data).length; ++i) {
      await bringIntoView(page, "#replay");
      await page.locator(`#tab-${i}`).click();
      await settle(page, 600);
      await bringIntoView(page, "#replay");
      await settle(page, 300);
      await page.screenshot({ path: join(out, `${colorScheme}-replay-${i + 1}.png`) });
    }
    for (const id of ["numbers", "plan", "validation", "calibration", "front", "convergence", "gains", "sensitivity", "robustness", "margins", "yardstick", "provenance"]) {
      if ((await page.locator(`#${id}`).count()) === 0) continue;
      await bringIntoView(page, `#${id}`);
      await settle(page, 400);
      await page.screenshot({ path: join(out, `${colorScheme}-${id}.png`) });
    }
    await context.close();
  }
}
