// Names are data: the same report with markup in every name shows it and runs none of it.
import { openPage, walkThrough } from "../browser.mjs";
import { dataOf, hasReplay, tabsOf, variant } from "./variant.mjs";

const SCRIPT = "<script>window.ran=1;alert(1)</script>";
const IMAGE = "<img src=x onerror=\"window.ran=1;alert(1)\">";
const CLOSING = "</script><script>window.ran=1</script><!--";
function withMarkup(data) {
  const changed = structuredClone(data);
  const arms = changed.robots;
  const joints = new Map((arms[0]?.joints ?? []).map((joint, i) => [joint.name, `${i % 2 === 0 ? SCRIPT : IMAGE}${i}`]));
  const renamed = (text) => [...joints].reduce((now, [from, to]) => now.split(from).join(to), text);
  for (const robot of arms) {
    robot.name = IMAGE;
    for (const joint of robot.joints) joint.name = joints.get(joint.name) ?? `${SCRIPT}${joint.name}`;
  }
  changed.title = CLOSING;
  changed.verdict.sentence += IMAGE;
  changed.verdict.details.push(SCRIPT);
  changed.sets = changed.sets.map((name) => `${name}${IMAGE}`);
  for (const table of [...changed.tables, ...(changed.judged?.tables ?? [])]) {
    table.scenario = `${SCRIPT}${table.scenario}`;
    table.reason = table.reason.map((text) => `${text}${IMAGE}`);
    table.status = table.status.map((text) => `${text}${SCRIPT}`);
    for (const row of table.rows) row.words += IMAGE;
  }
  if (changed.judged !== undefined) changed.judged.measure += SCRIPT;
  for (const figure of changed.plan?.figures ?? []) figure[1] += SCRIPT;
  if (changed.plan !== undefined) changed.plan.scenario += IMAGE;
  for (const scenario of changed.scenarios) {
    for (const limit of scenario.limits ?? []) {
      limit.column = renamed(limit.column);
      limit.part = renamed(limit.part);
      limit.words = `${renamed(limit.words)}${IMAGE}`;
    }
    scenario.name = `${IMAGE}${scenario.name}`;
    scenario.states = scenario.states.map((name) => `${name}${SCRIPT}`);
    for (const run of scenario.runs) {
      run.status = `diverged${IMAGE}`;
      run.reason = SCRIPT;
      for (const column of run.columns) column.name = renamed(column.name);
    }
  }
  for (const gain of changed.gains ?? []) gain.name = `${gain.name}${IMAGE}`;
  for (const one of changed.sensitivity ?? []) one.gain = `${one.gain}${SCRIPT}`;
  for (const margin of changed.margins ?? []) {
    margin.reason = margin.reason.map((text) => `${text}${IMAGE}`);
    margin.text = margin.text.map((text) => `${text}${SCRIPT}`);
  }
  for (const one of changed.yardstick ?? []) {
    one.scenario = `${SCRIPT}${one.scenario}`;
    one.words = `${IMAGE}${one.words}`;
    one.held_back_by = `${one.held_back_by}${SCRIPT}`;
  }
  for (const point of changed.front?.points ?? []) point.label += IMAGE;
  for (const one of changed.robustness?.worst ?? []) one.text += SCRIPT;
  for (const one of [...(changed.validation?.torques ?? []), ...(changed.validation?.motion ?? [])]) one.joint += IMAGE;
  if (changed.validation !== undefined) changed.validation.commands += SCRIPT;
  for (const one of changed.calibration?.joints ?? []) one.joint += IMAGE;
  for (const one of changed.calibration?.parameters ?? []) {
    one.name += IMAGE;
    one.unit += SCRIPT;
    one.motion = SCRIPT;
  }
  changed.provenance.command += CLOSING;
  changed.provenance.entries.push([SCRIPT, IMAGE]);
  return changed;
}

export async function checkInert({ browser, file, folder, expect }) {
  const data = withMarkup(dataOf(file));
  const address = variant(file, data, folder, "markup.html");
  const { page, context, requests, complaints, dialogs } = await openPage(browser, address);
  await walkThrough(page);
  for (let i = 1; i < (await page.locator("[role=tab]").count()); ++i) {
    await page.locator(`#tab-${i}`).click();
    await walkThrough(page, "#replay");
  }
  expect((await page.evaluate(() => window.ran)) === undefined && dialogs.length === 0, "markup in names runs nothing");
  expect((await page.evaluate(() => document.images.length)) === 0, "markup in names makes no elements");
  expect(requests.length === 1, "markup in names asks for nothing");
  expect(complaints.length === 0, `and breaks nothing${complaints.length ? `: ${complaints[0]}` : ""}`);
  expect((await page.textContent("h1")).endsWith(IMAGE), "it is shown as it is, in the verdict");
  const shown = tabsOf(data);
  if (shown.length > 0) {
    if (hasReplay(data, shown[0])) expect((await page.textContent(".meters .name")).startsWith(SCRIPT), "as a joint's name");
    expect((await page.textContent("#tab-0")) === shown[0].name, "as a scenario's name");
  }
  await context.close();
}
