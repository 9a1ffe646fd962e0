import assert from "node:assert/strict";
import { test } from "node:test";
import { liveWords } from "../src/live";

const live = { evaluations: 12, most_evaluations: 300, seconds_left: 240, every: 3, written: 1_700_000_000 };

test("a page that is fresh says how far the run is, and when that was", () => {
  const words = liveWords(live, live.written + 5);
  assert.match(words, /^12 of 300 evaluations, about 4 min left\. Written at 22:13:20 UTC/);
  assert.doesNotMatch(words, /No new page/);
});

test("one that stands still says so, instead of a time left", () => {
  const words = liveWords(live, live.written + 600);
  assert.match(words, /^12 of 300 evaluations\. No new page for 10 min: .* was killed .*--resume/);
  assert.doesNotMatch(words, /left/);
  // Pages that take long come seldom.
  assert.doesNotMatch(liveWords({ ...live, every: 60 }, live.written + 300), /No new page/);
});
