// Everything that should be drawn is drawn.
import { bringIntoView, settle, walkThrough } from "../browser.mjs";

/** Portion of pixels that are not background: axes alone are 1 to 2 percent, a line adds to them. */
const NOT_BLANK = 0.01;

/** Portion of a plot's drawing area, inside the axes, that is not background: nothing but what is plotted. */
async function plotted(page, selector) {
  return page.evaluate((s) => {
    return [...document.querySelectorAll(s)].map((figure) => {
      const canvas = figure.querySelector("canvas");
      const over = figure.querySelector(".u-over");
      const scale = canvas.width / canvas.clientWidth;
      const [left, top] = [parseFloat(over.style.left) * scale, parseFloat(over.style.top) * scale];
      const [width, height] = [over.clientWidth * scale, over.clientHeight * scale];
      const { data } = canvas.getContext("2d").getImageData(left, top, width, height);
      // Colour that is no grey and no faint band: a line, or a mark.
      let strong = 0;
      for (let i = 0; i < data.length; i += 4) {
        if (data[i + 3] < 150) continue;
        if (Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 40) ++strong;
      }
      return { title: figure.querySelector(".plot-title")?.textContent ?? "", strong };
    });
  }, selector);
}

export async function checkDrawn({ page, data, expect, pictures }) {
  expect((await page.textContent("h1"))?.trim().replaceAll("\u00a0", " ") === data.verdict.sentence, "the verdict stands on top");
  await walkThrough(page);
  const tabs = await page.locator("[role=tab]").count();
  const withRuns = data.scenarios.filter((scenario) => scenario.runs.length > 0);
  expect(tabs === withRuns.length, `a tab for each of ${withRuns.length} scenarios`);
  for (let i = 0; i < tabs; ++i) {
    await page.locator(`#tab-${i}`).click();
    await settle(page, 400);
    await walkThrough(page);
    const groups = new Set(withRuns[i].runs.flatMap((run) => run.columns.map((column) => column.group)));
    const plots = await plotted(page, `#panel-${i} .plot`);
    expect(plots.length === groups.size, `${groups.size} time plots of scenario ${i + 1}`);
    for (const { title, strong } of plots) expect(strong > 20, `scenario ${i + 1}: '${title}' shows lines (${strong} px)`);
    await bringIntoView(page, `#panel-${i} .stage`);
    await settle(page, 300);
    const stage = await page.locator(`#panel-${i} .stage canvas`).screenshot();
    const drawn = await pictures.drawn(stage);
    expect(drawn > NOT_BLANK, `scenario ${i + 1}: the 3D canvas is not blank (${(100 * drawn).toFixed(1)} % drawn)`);
  }
  for (const id of ["front", "convergence"]) {
    if ((await page.locator(`#${id}`).count()) === 0) continue;
    await bringIntoView(page, `#${id}`);
    const plots = await plotted(page, `#${id} .plot`);
    expect(plots.length === 1 && plots[0].strong > 20, `the plot of '${id}' shows marks`);
  }
  const drawings = await page.evaluate(() =>
    [...document.querySelectorAll(".drawing")].map((one) => one.querySelectorAll("svg rect, svg circle").length),
  );
  expect(drawings.every((marks) => marks > 0), `all ${drawings.length} drawings have marks`);
  for (const [part, id] of [
    ["front", "front"],
    ["evaluations", "convergence"],
    ["gains", "gains"],
    ["sensitivity", "sensitivity"],
    ["robustness", "robustness"],
    ["margins", "margins"],
    ["provenance", "provenance"],
  ]) {
    const there = data[part] !== undefined && (!Array.isArray(data[part]) || data[part].length > 0);
    const shown = (await page.locator(`#${id}`).count()) === 1;
    if (part !== "evaluations" || !there || data.evaluations.objective.length > 0) {
      expect(there === shown, `section '${id}' is ${there ? "there" : "left out"}`);
    }
  }
}
