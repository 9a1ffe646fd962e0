// A browser for the checks: Debian's Chromium, or what the variable CHROMIUM names.
import { existsSync } from "node:fs";
import { chromium } from "playwright-core";

const PLACES = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

export function findBrowser() {
  const found = process.env.CHROMIUM ?? PLACES.find((place) => existsSync(place));
  if (found === undefined) throw new Error("no Chromium found: apt-get install chromium, or set CHROMIUM to its path");
  return found;
}

/** webGl: in software, so that it draws on machines without graphics; the page around it without it, which is three
 * times as quick there. */
export function launch({ webGl = true } = {}) {
  const drawing = webGl
    ? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-gpu-compositing"]
    : ["--disable-gpu", "--disable-3d-apis"];
  const sandbox = process.getuid?.() === 0 ? ["--no-sandbox"] : [];
  return chromium.launch({ executablePath: findBrowser(), args: [...drawing, ...sandbox] });
}

/** Ends a browser that may no longer answer. */
export async function end(browser) {
  await Promise.race([browser.close().catch(() => {}), new Promise((done) => setTimeout(done, 10_000))]);
}

/** What the browser says of its own copying of pictures, where it draws in software; nothing of the page's doing. */
const OF_THE_DRIVER = /GL Driver Message \(OpenGL, Performance.*GPU stall due to ReadPixels/;

/** Opens a page and writes down what it asks for and complains of. */
export async function openPage(browser, address, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1440, height: 900 },
    acceptDownloads: true,
    // Without the page's smooth scrolling, which takes a dozen drawings of all that is in view for every stop.
    reducedMotion: "reduce",
    ...options,
  });
  await withNextFrame(context);
  const page = await context.newPage();
  const requests = [];
  const complaints = [];
  const dialogs = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !OF_THE_DRIVER.test(message.text())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.message}`));
  page.on("dialog", (dialog) => {
    dialogs.push(dialog.message());
    void dialog.dismiss();
  });
  await page.goto(address);
  return { page, context, requests, complaints, dialogs };
}

export async function bringIntoView(page, selector) {
  await page.evaluate((s) => document.querySelector(s)?.scrollIntoView({ block: "start", behavior: "instant" }), selector);
  await settle(page);
}

/** What a page says that waits for a frame and gets none: chromium at times stops drawing in software. */
export const NO_FRAME = "the browser has drawn nothing for 20 s";

/** In the page: `nextFrame()`, which gives up with NO_FRAME. */
const withNextFrame = (context) =>
  context.addInitScript((words) => {
    window.nextFrame = () =>
      new Promise((done, fail) => {
        const late = setTimeout(() => fail(new Error(words)), 20_000);
        requestAnimationFrame(() => {
          clearTimeout(late);
          done();
        });
      });
  }, NO_FRAME);

/** Two frames after which nothing that was asked for is still to be drawn, and the time for lazy parts. */
export async function settle(page, ms = 150) {
  await page.evaluate(async () => {
    for (let i = 0; i < 2; ++i) await window.nextFrame();
  });
  await page.waitForTimeout(ms);
}

/** Walks down the page from an element or its top, so that everything that waits for being seen is made. What is
 * within 300 px of the window counts as seen, so steps of a window leave nothing out. */
export async function walkThrough(page, from = "body") {
  await page.evaluate(async (selector) => {
    const begin = document.querySelector(selector).getBoundingClientRect().top + scrollY;
    for (let top = Math.max(begin, 0); top < document.body.scrollHeight; top += innerHeight) {
      window.scrollTo({ top, behavior: "instant" });
      // One to see what is near, one to make it, one to draw it.
      for (let i = 0; i < 3; ++i) await window.nextFrame();
    }
  }, from);
}
