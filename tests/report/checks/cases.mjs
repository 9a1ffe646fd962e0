// What a report may hold and short runs seldom do: runs that ended early, no replay, several arms, native evaluations,
// a shown point, limits, margins in words. Made from any report that has a replay.
import { bringIntoView, openPage, settle, walkThrough } from "../browser.mjs";
import { plotted } from "./drawn.mjs";
import { seconds } from "./replay.mjs";
import { hasReplay, tabsOf, variant } from "./variant.mjs";

const REASON = "diverged at 4.206 s in followTrajectory: wrist_3_joint moves at -64.2, over 20 times its velocity limit";
const EARLY = 0.45;  // of the run

const firstOf = (series, n) => ({ ...series, u16: Buffer.from(series.u16, "base64").subarray(0, 2 * n).toString("base64") });

function valuesOf({ lo, hi, u16 }) {
  const bytes = Buffer.from(u16, "base64");
  return Array.from({ length: bytes.length >> 1 }, (_, i) => lo + ((hi - lo) / 65534) * bytes.readUInt16LE(2 * i));
}

/** The run as if it had ended at a time. */
function endedAt(run, end, set) {
  const n = valuesOf(run.time).filter((t) => t <= end).length;
  const m = Math.floor(end / run.replay.dt) + 1;
  const cut = (all) => all.map((one) => firstOf(one, m));
  const { replay } = run;
  return {
    ...run,
    set,
    end,
    status: "diverged",
    reason: REASON,
    time: firstOf(run.time, n),
    columns: run.columns.map((column) => ({ ...column, series: firstOf(column.series, n) })),
    states: run.states.filter((change) => change.t <= end),
    replay: {
      ...replay,
      n: m,
      q: cut(replay.q),
      target: cut(replay.target),
      tool: cut(replay.tool),
      velocity_ratio: cut(replay.velocity_ratio),
      obstacles: replay.obstacles.map(cut),
      error: firstOf(replay.error, m),
    },
  };
}

const withoutReplay = (run) => ({
  ...run,
  replay: { dt: run.replay.dt, n: 0, q: [], target: [], obstacles: [], tool: [], error: { lo: 0, hi: 0, u16: "" }, velocity_ratio: [] },
});

function casesOf(data) {
  const scenario = tabsOf(data).find((one) => hasReplay(data, one));
  const whole = { ...scenario.runs.at(-1), set: 0, end: scenario.duration, status: "completed", reason: "" };
  const end = EARLY * scenario.duration;
  const ended = endedAt(whole, end, 1);
  const arm = data.robots[scenario.robot];
  const other = { ...arm, name: "another arm", undrawn: 2, joints: arm.joints.map((joint) => ({ ...joint, name: `other ${joint.name}` })) };
  const row = { metric: "some/metric", unit: "m", words: "a metric in words", meaning: "", values: [2, 1], better: "lower" };
  const table = { scenario: "both", rows: [row, { ...row, better: "higher" }], status: ["completed", "diverged"], reason: ["", REASON] };
  const point = (values, role) => ({ values, label: role === "start" ? "start" : "a point", feasible: true, role });
  return {
    end,
    joint: arm.joints[0].name,
    data: {
      ...data,
      sets: ["whole", "ended"],
      tables: [table],
      judged: { measure: "worst of 5 arms in each scenario", tables: [table] },
      robots: [arm, other],
      scenarios: [
        { ...scenario, name: "both", robot: 0, runs: [whole, ended] },
        { ...scenario, name: "ended alone", robot: 0, runs: [{ ...ended, set: 0 }] },
        { ...scenario, name: "no replay", robot: 0, runs: [withoutReplay(whole)] },
        { ...scenario, name: "no arm", robot: -1, runs: [withoutReplay(whole)] },
        { ...scenario, name: "other arm", robot: 1, runs: [whole] },
      ],
      evaluations: {
        phase: ["start", "search"],
        of: [0, 1, 1, 1, 1, 1],
        objective: [4, 3.5, 1, 3, 2, 2.5],
        feasible: [true, true, true, true, false, true],
        violation: [0, 0, 0, 0, 0.5, 0],
        native: [false, true, true, false, true, false],
        start: 0,
        chosen: 5,
      },
      gains: undefined,
      sensitivity: undefined,
      robustness: undefined,
      margins: [{ margin: "delay", unit: "periods", scenario: "all", values: [100, 0], text: ["≥ 100", "none"], reason: ["", REASON] }],
      yardstick: [
        { set: 0, scenario: "both", event: "switch", time: 8, reached: 1.48, limit: 1.21, ratio: 1.48 / 1.21, unit: "s", held_back_by: "velocity of elbow_joint", words: "reacquired in 1.48 s; the joint limits allow 1.21 s (velocity of elbow_joint)" },
        { set: 1, scenario: "both", event: "switch", time: 8, reached: null, limit: 1.21, ratio: null, unit: "s", held_back_by: "nothing", words: "not reacquired: not before the next switch; the joint limits allow 1.21 s" },
        { set: 1, scenario: "both", event: "lap", time: 10, reached: 0.012, limit: 0.0004, ratio: 30, unit: "rad", held_back_by: "nothing", words: "a gaze error of 12 mrad rms; the joint limits allow 0.4 mrad" },
        { set: 1, scenario: "both", event: "return", time: 6, reached: null, limit: null, ratio: null, unit: "s", held_back_by: "", words: "not back on the path: cut off by an obstacle; the best possible is unknown: not solved" },
      ],
      front: {
        criteria: [{ name: "first", unit: "1" }, { name: "second", unit: "1" }],
        points: [point([1, 4], "start"), point([2, 3], "point"), point([3, 2], "chosen"), point([4, 1], "shown")],
        limits: [{ criterion: 0, value: 3.5 }, { criterion: 1, value: 4.5 }],
        hypervolume: null,
      },
    },
  };
}

async function seek(page, time) {
  await page.evaluate((to) => {
    const slider = document.querySelector(".panel:not([hidden]) .scrub");
    slider.value = to;
    slider.dispatchEvent(new Event("input"));
  }, String(time));
  await settle(page, 30);
}

async function openTab(page, i) {
  await page.locator(`#tab-${i}`).click();
  await walkThrough(page, "#replay");
  await bringIntoView(page, "#replay");
}

const inPanel = (page, part) => page.locator(`.panel:not([hidden]) ${part}`);

async function checkEnds({ page, cases, expect }) {
  const { end } = cases;
  const { duration } = cases.data.scenarios[0];
  const reading = () => inPanel(page, ".reading").first().textContent();
  const said = () => inPanel(page, ".over-now").textContent();
  expect((await seconds(page)) < end, `a run that ended at ${end.toFixed(2)} s is opened within it`);
  expect((await said()) === "" && !(await reading()).includes("–"), "before its end nothing is said of it");
  await seek(page, duration);
  expect(Math.abs((await seconds(page)) - duration) < 0.01, "of two runs the later end is the slider's");
  expect((await said()) === `ended: ${REASON}`, "the replay says when and why the other ended");
  expect((await reading()).trim().endsWith("→ –"), `the legend has no value of it any more (${await reading()})`);
  expect((await inPanel(page, ".meters .figure").allTextContents()).every((text) => text === "–"), "nor has a joint a velocity");
  expect((await inPanel(page, ".trouble").textContent()).includes(REASON), "the reason stands above the replay");
  const place = await inPanel(page, ".strip .over").evaluate((part) => parseFloat(part.style.left));
  expect(Math.abs(place - 100 * EARLY) < 0.5, "the strip shows where it ended");
  await openTab(page, 1);
  const most = await inPanel(page, ".scrub").evaluate((slider) => Number(slider.max));
  expect(Math.abs(most - end) < 0.01, "a run that ended early, alone, is as long as it was");
  const axis = await inPanel(page, ".plot").first().evaluate((plot) => Number(plot.dataset.to));
  expect(Math.abs(axis - end) < 0.01, "and so are its plots");
  expect((await page.locator("#numbers .status").first().textContent()).includes(REASON), "the reason stands in the table");
}

async function checkWords({ page, expect }) {
  for (const [tab, words] of [[2, "joint positions"], [3, "about the arm"]]) {
    await openTab(page, tab);
    const text = await inPanel(page, ".no-replay").textContent({ timeout: 3000 });
    expect(text.includes("No replay") && text.includes(words), `without a replay words stand in its place (${text})`);
    expect((await inPanel(page, ":is(.controls, .key, .stage)").count()) === 0, "and neither controls nor a legend of it");
    const plots = await plotted(page, ".panel:not([hidden]) .plot");
    expect(plots.length > 0 && plots.every((plot) => plot.strong > 20), `but its ${plots.length} plots are drawn`);
  }
}

async function checkArms({ page, cases, expect }) {
  await openTab(page, 4);
  expect((await inPanel(page, ".meters .name").first().textContent()) === `other ${cases.joint}`, "each scenario has its own arm's joints");
  expect((await inPanel(page, ".arm-name").textContent()).includes("another arm"), "and names it");
  expect((await inPanel(page, ".undrawn").textContent()).startsWith("2 shapes"), "and says what of it is not drawn");
}

async function checkMarks({ page, expect, touch }) {
  for (const [id, entries] of [
    ["convergence", ["feasible, in the native engine", "best feasible so far, in either engine", "chosen"]],
    ["front", ["start", "chosen", "shown here"]],
  ]) {
    await bringIntoView(page, `#${id}`);
    await settle(page, 50);
    const legend = await page.locator(`#${id} .legend .entry`).allTextContents();
    for (const entry of entries) expect(legend.some((one) => one.startsWith(entry)), `the legend of '${id}' has '${entry}'`);
    const shapes = await page.locator(`#${id} .legend .swatch`).evaluateAll((all) => all.map((one) => one.className));
    expect(shapes.some((name) => name.includes("ring")) && shapes.some((name) => name.includes("diamond")), "start and chosen differ in shape");
    const told = () => page.textContent(`#${id} .told`);
    const read = [await told()];
    await page.locator(`#${id} .plot`).focus();
    for (let i = 0; i < 2; ++i) {
      await page.keyboard.press("ArrowRight");
      read.push(await told());
    }
    expect(new Set(read).size === 3, `arrow keys step through the marks of '${id}' (${read[2]})`);
    const ring = await page.locator(`#${id} .picked`).boundingBox();
    await page.keyboard.press("ArrowLeft");
    await page.mouse.move(4, 4);
    await touch(ring.x + ring.width / 2, ring.y + ring.height / 2);
    await settle(page, 30);
    expect((await told()) === read[2], "and a tap reads one");
  }
}

async function checkNumbers({ page, expect }) {
  const ways = await page.locator("#numbers .way").allTextContents();
  expect(ways.join() === "better,worse,better,worse", "better and worse are words");
  const [heading] = await page.locator("#numbers h3").allTextContents();
  expect(heading.includes("worst of 5 arms in each scenario"), "what the study is judged by comes first and says so");
  const [name] = await page.locator("#numbers tbody th").allTextContents();
  expect(name.includes("a metric in words") && name.includes("some/metric"), "a metric has words and its name");
  const margins = await page.locator("#margins td b").allTextContents();
  expect(margins.join() === "≥ 100,none", "margins stand as they are worded");
}

async function checkYardstick({ page, expect }) {
  await bringIntoView(page, "#yardstick");
  await settle(page, 50);
  const titles = await page.locator("#yardstick .plot-title").allTextContents();
  expect(titles.length === 2, `the yardstick has a plot of each kind that has figures (${titles.length})`);
  expect(titles[0].endsWith("[s]") && titles[1].endsWith("[mrad]"), "with its unit");
  const [reached, limit] = await page.locator("#yardstick svg rect").evaluateAll((all) => all.map((one) => Number(one.getAttribute("width"))));
  expect(Math.abs(reached / limit - 1.48 / 1.21) < 1e-6, "reached and limit are as long as they are large");
  const bars = await page.locator("#yardstick svg rect").count();
  expect(bars === 5, `what was not reached has no bar (${bars} bars of three events)`);
  const rows = await page.locator("#yardstick tbody tr").allTextContents();
  expect(rows.length === 4 && rows[0].includes("1.48") && rows[0].includes("the joint limits allow"), "each event has a row in words");
  expect(rows[2].includes("12") && rows[2].includes("mrad") && rows[2].includes("0.4"), "radians as mrad");
  expect(rows[3].split("–").length >= 4, "what there is not is a dash");
}

export async function checkCases({ browser, file, folder, data, expect }) {
  if (!tabsOf(data).some((scenario) => hasReplay(data, scenario))) return;
  const cases = casesOf(data);
  const { page, context, complaints } = await openPage(browser, variant(file, cases.data, folder, "cases.html"), { hasTouch: true });
  const all = { page, cases, expect, touch: (x, y) => page.touchscreen.tap(x, y) };
  await walkThrough(page);
  await bringIntoView(page, "#replay");
  await checkNumbers(all);
  await checkEnds(all);
  await checkWords(all);
  await checkArms(all);
  await checkMarks(all);
  await checkYardstick(all);
  expect(complaints.length === 0, `none of it brings a complaint${complaints.length ? `: ${complaints[0]}` : ""}`);
  await context.close();
}
