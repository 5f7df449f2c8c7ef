// The page of a study as a reader meets it, from disk and from `rigor study --view`.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { makeStudy, openBrowser, openStudy, removePages, serveStudy, settle } from "./pages.mjs";

const text = `rigor_study: 1
name: bounces
scene: ${new URL("../../scenes/bouncing_ball.yaml", import.meta.url).pathname}
kind: monte-carlo
runs: 40
set: {run: {duration: 1, output_interval: 0.05, step: 0.05}, expect: []}
parameters:
  - {name: e, key: materials.rubber.restitution, range: [0.3, 0.9]}
  - {name: height, range: [0.5, 2]}
assign: {bodies.ball.position: [0, 0, height]}
outcomes:
  - {name: impacts, count: impact}
  - {name: top, max: body.ball.position.z}
`;

let browser, study;
before(async () => {
  browser = await openBrowser();
  study = makeStudy("bounces", text, "--keep");
});
after(async () => {
  await browser?.close();
  removePages();
});

const sizes = [{ width: 1440, height: 900 }, { width: 1280, height: 720 }, { width: 390, height: 844 }];

test("the page loads without errors at any width, asks for nothing else and is no wider than the window", async () => {
  for (const viewport of sizes) {
    const { page, errors, requests } = await openStudy(browser, `file://${study.html}`, { viewport });
    await settle(page);
    assert.deepEqual(errors, []);
    assert.deepEqual(requests, [`file://${study.html}`]);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `at ${viewport.width}`);
    // Both plots have drawn something.
    const drawn = await page.evaluate(() => [...document.querySelectorAll("#runs canvas")].map((canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return data.some((value) => value !== 0);
    }));
    assert.deepEqual(drawn, [true, true]);
    await page.close();
  }
});

test("a click on a dot chooses its run, whose numbers are those of the table", async () => {
  const { page } = await openStudy(browser, `file://${study.html}`, { viewport: sizes[0] });
  const canvas = page.locator("#runs canvas").nth(1);
  const box = await canvas.boundingBox();
  // Somewhere in the plot there is a dot within reach: look over it as a hand does.
  let chosen = -1;
  for (let y = 20; y < box.height - 50 && chosen < 0; y += 12) {
    for (let x = 70; x < box.width - 20 && chosen < 0; x += 12) {
      await canvas.click({ position: { x, y } });
      chosen = await page.evaluate(() => window.rigorStudy.selection.chosen);
    }
  }
  assert.ok(chosen >= 0);
  const row = study.rows[chosen];
  assert.equal(await page.locator(".chosen h3").textContent(), `Run ${row.run}: ${row.status}`);
  const shown = await page.evaluate(() => window.rigorStudy.study.columns.map(({ name, values }) => [name, values[window.rigorStudy.selection.chosen]]));
  for (const [name, value] of shown) assert.equal(value, Number(row[name]), name);
  await page.close();
});

test("a drag along an axis keeps the runs of that range, a click on it gives all back", async () => {
  for (const viewport of [sizes[0], sizes[2]]) {
    const { page } = await openStudy(browser, `file://${study.html}`, { viewport });
    const canvas = page.locator("#runs canvas").first();
    await canvas.scrollIntoViewIfNeeded();
    const box = await canvas.boundingBox(), isLying = viewport.width < 640;
    const at = (share) => isLying ? [box.x + 20 + share * (box.width - 40), box.y + 30] : [box.x + 56, box.y + box.height - 24 - share * (box.height - 58)];
    await page.mouse.move(...at(0.5));
    await page.mouse.down();
    await page.mouse.move(...at(0.8));
    await page.mouse.move(...at(1));
    await page.mouse.up();
    const e = study.rows.map((row) => Number(row.e)), low = Math.min(...e), high = Math.max(...e);
    const wanted = e.filter((value) => value >= (low + high) / 2).length;
    const count = await page.evaluate(() => window.rigorStudy.study.runs.filter((_, i) => window.rigorStudy.selection.holds(i)).length);
    // The pointer stands between pixels.
    assert.ok(Math.abs(count - wanted) <= 1, `${count} of ${wanted}`);
    assert.match(await page.locator(".chosen [role=status]").textContent(), new RegExp(`^${count} of 40 runs`));
    await page.mouse.click(...at(0.7));
    assert.equal(await page.evaluate(() => window.rigorStudy.selection.ranges.size), 0);
    await page.close();
  }
});

test("a kept run replays from its file", async () => {
  const { page } = await openStudy(browser, `file://${study.html}`, { viewport: sizes[0] });
  await page.locator(".chosen input").fill("7");
  await page.locator(".chosen input").press("Enter");
  const [replay] = await Promise.all([page.waitForEvent("popup"), page.locator("a.replay").click()]);
  await replay.waitForSelector(".app");
  assert.match(replay.url(), /bounces_runs\/run_7\.html$/);
  assert.match(await replay.title(), /bounces, run 7/);
  await page.close();
});

test("a served study replays a run that is carried out again, and nothing without the token", async () => {
  const { url, end } = await serveStudy(study.file);
  const { page, errors } = await openStudy(browser, url, { viewport: sizes[1] });
  await page.locator(".chosen input").fill("12");
  await page.locator(".chosen input").press("Enter");
  const [replay] = await Promise.all([page.waitForEvent("popup"), page.locator("a.replay").click()]);
  const wrong = [];
  replay.on("pageerror", (error) => wrong.push(error.message));
  await replay.waitForSelector(".app");
  await settle(replay);
  assert.match(await replay.title(), /bounces, run 12/);
  // The replay is that of the row: as high, and with as many impacts.
  const top = await replay.evaluate(() => window.rigor.source.header.bodies.length);
  assert.ok(top >= 1);
  assert.deepEqual([errors, wrong], [[], []]);
  const status = async (path) => (await fetch(new URL(path, url))).status;
  const token = new URL(url).searchParams.get("token");
  assert.equal(await status("/run/12"), 403);
  assert.equal(await status(`/run/40?token=${token}`), 404);
  assert.equal(await status(`/run/x?token=${token}`), 404);
  assert.equal(await status(`/run/39?token=${token}`), 200);
  assert.equal(await status("/other.js"), 404);
  await page.close();
  assert.equal(await end(), 0);
});
