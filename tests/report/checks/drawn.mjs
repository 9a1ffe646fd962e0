// Everything that should be drawn is drawn.
import { bringIntoView, walkThrough } from "../browser.mjs";
import { hasReplay, tabsOf } from "./variant.mjs";

/** Portion of a plot's drawing area, inside the axes, that is not background: nothing but what is plotted. */
export async function plotted(page, selector) {
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

export async function checkDrawn({ page, data, expect }) {
  expect((await page.textContent("h1"))?.trim().replaceAll("\u00a0", " ") === data.verdict.sentence, "the verdict stands on top");
  await walkThrough(page);
  const tabs = await page.locator("[role=tab]").count();
  const withRuns = tabsOf(data);
  expect(tabs === withRuns.length, `a tab for each of ${withRuns.length} scenarios`);
  for (let i = 0; i < tabs; ++i) {
    if (i > 0) {
      await page.locator(`#tab-${i}`).click();
      await walkThrough(page, "#replay");
    }
    const groups = new Set(withRuns[i].runs.flatMap((run) => run.columns.map((column) => column.group)));
    const plots = await plotted(page, `#panel-${i} .plot`);
    expect(plots.length === groups.size, `${groups.size} time plots of scenario ${i + 1}`);
    for (const { title, strong } of plots) expect(strong > 20, `scenario ${i + 1}: '${title}' shows lines (${strong} px)`);
    // That the arm is in it: arm.mjs.
    const count = (part) => page.locator(`#panel-${i} ${part}`).count();
    const [stages, words, controls] = [await count(".stage canvas"), await count(".no-replay"), await count(".controls")];
    if (hasReplay(data, withRuns[i])) expect(stages === 1 && words === 0 && controls === 1, `scenario ${i + 1} has a replay`);
    else expect(stages === 0 && words === 1 && controls === 0, `scenario ${i + 1} says why there is no replay`);
  }
  for (const id of ["front", "convergence"]) {
    if ((await page.locator(`#${id}`).count()) === 0) continue;
    await bringIntoView(page, `#${id}`);
    const plots = await plotted(page, `#${id} .plot`);
    expect(plots.length === 1 && plots[0].strong > 20, `the plot of '${id}' shows marks`);
  }
  if (data.validation !== undefined) {
    const plots = await plotted(page, "#validation .plot");
    const joints = data.validation.torques.length + data.validation.motion.length;
    expect(plots.length === joints, `${joints} plots of the validation`);
    for (const { title, strong } of plots) expect(strong > 20, `the validation of '${title}' shows lines (${strong} px)`);
  }
  if (data.calibration !== undefined) {
    const { joints, parameters } = data.calibration;
    const plots = await plotted(page, "#calibration .plot");
    expect(plots.length === joints.length, `${joints.length} plots of the calibration`);
    for (const { title, strong } of plots) expect(strong > 20, `the calibration of '${title}' shows lines (${strong} px)`);
    expect((await page.locator("#calibration .scroll tbody tr").count()) === parameters.length, `${parameters.length} parameters`);
  }
  const cards = data.tables.length + (data.judged?.tables.length ?? 0);
  expect((await page.locator("#numbers .card").count()) === cards, `${cards} tables`);
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
    ["plan", "plan"],
    ["validation", "validation"],
    ["calibration", "calibration"],
    ["yardstick", "yardstick"],
    ["provenance", "provenance"],
  ]) {
    const there = data[part] !== undefined && (!Array.isArray(data[part]) || data[part].length > 0);
    const shown = (await page.locator(`#${id}`).count()) === 1;
    if (part !== "evaluations" || !there || data.evaluations.objective.length > 0) {
      expect(there === shown, `section '${id}' is ${there ? "there" : "left out"}`);
    }
  }
}
