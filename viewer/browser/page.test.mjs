// The page as a reader meets it: opened from disk in Chromium, without a network.
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { after, before, test } from "node:test";
import { makePage, openBrowser, openPage, removePages, settle, writePage } from "./pages.mjs";

let browser;
let cradle;
before(async () => {
  browser = await openBrowser();
  cradle = makePage("cradle");
});
after(async () => {
  await browser?.close();
  removePages();
});

/** Two numbers that are equal but for what the page says it stores. */
const near = (a, b, error, what) => assert.ok(Math.abs(a - b) <= error, `${what}: ${a} is not ${b} to ${error}`);
const state = (page) => page.evaluate(() => ({
  time: window.rigor.playback.time,
  isPlaying: window.rigor.playback.isPlaying,
  bodies: window.rigor.source.header.bodies.map((_, i) => window.rigor.positionOf(i)),
  error: window.rigor.source.header.position_error,
}));

/** Waits for something to become true in the page (Playwright's own way needs eval, which the page forbids). */
async function until(page, isTrue) {
  for (let tries = 0; tries < 500; ++tries) {
    if (await page.evaluate(isTrue)) return;
    await page.waitForTimeout(20);
  }
  assert.fail(`never true: ${isTrue}`);
}

test("pages of shipped scenes load without console errors and ask for nothing else", async () => {
  for (const scene of ["turntable", "billiards", "rocks", "tennis_racket"]) {
    const { html } = makePage(scene);
    const { page, errors, requests } = await openPage(browser, html);
    await settle(page);
    assert.deepEqual(errors, [], scene);
    assert.deepEqual(requests, [`file://${html}`], scene);
    assert.ok(await page.evaluate(() => window.rigor.view !== undefined), `${scene}: the scene is drawn`);
    await page.close();
  }
});

test("the keyboard steps through the frames to the stored positions", async () => {
  const { page } = await openPage(browser, cradle.html);
  const check = async (row) => {
    await settle(page);
    const { time, bodies, error } = await state(page);
    assert.equal(time, row.time);
    row.position.forEach((position, body) => position.forEach((x, c) => near(bodies[body][c], x, 1.01 * error, `body ${body}`)));
  };
  const rows = cradle.run.trajectory;
  await page.keyboard.press("End");
  await check(rows.at(-1));
  await page.keyboard.press("ArrowLeft");
  await check(rows.at(-2));
  await page.keyboard.press("Home");
  await check(rows[0]);
  await page.keyboard.press("Shift+ArrowRight");
  await check(rows[10]);
  await page.close();
});

test("dragging the scrubber moves the bodies to where they were stored", async () => {
  const { page } = await openPage(browser, cradle.html);
  const line = await page.locator("#scrubber").boundingBox();
  await page.mouse.move(line.x + 0.5 * line.width, line.y + 15);
  await page.mouse.down();
  await page.mouse.move(line.x + 0.83 * line.width, line.y + 15, { steps: 5 });
  await page.mouse.up();
  await settle(page);
  const { time, bodies, error } = await state(page);
  near(time, 0.83, 0.01, "time");
  // After the last impact all balls move evenly: between two rows of the trajectory on a straight line.
  const rows = cradle.run.trajectory;
  const k = rows.findIndex((row) => row.time > time);
  const part = (time - rows[k - 1].time) / (rows[k].time - rows[k - 1].time);
  bodies.forEach((position, body) => position.forEach((x, c) => {
    const [a, b] = [rows[k - 1].position[body][c], rows[k].position[body][c]];
    near(x, a + part * (b - a), 2 * error, `body ${body}`);
  }));
  await page.close();
});

test("a click on a tick jumps to that impact, shows its impulse, and the balls touch", async () => {
  const { page } = await openPage(browser, cradle.html);
  const impacts = cradle.run.trajectory.flatMap((row) => row.events).filter((event) => event.kind === "impact");
  assert.ok(impacts.length > 1);
  const impact = impacts[1];
  const line = await page.locator("#scrubber").boundingBox();
  await page.mouse.click(line.x + impact.time * line.width + 1, line.y + 10);
  await settle(page);
  const { time, isPlaying, bodies, error } = await state(page);
  near(time, impact.time, 1e-9, "time");
  assert.equal(isPlaying, false);
  const text = await page.locator("#event").innerText();
  assert.match(text, /impact at/);
  for (const body of impact.bodies) assert.ok(text.includes(cradle.run.bodies[body]), text);
  const size = Math.hypot(...impact.impulse);
  const shown = Number(/impulse\s+([\d.e−]+)/.exec(text)[1].replace("−", "-"));
  near(shown, size, 1e-4 * size, "impulse");
  // The balls have radius 0.05 m in the scene: their centres are two of them apart.
  const [a, b] = impact.bodies.map((body) => bodies[body]);
  const radius = await page.evaluate(() => window.rigor.source.header.bodies[0].radius);
  near(Math.hypot(...a.map((x, c) => x - b[c])), 2 * radius, 4 * error, "distance at the impact");
  await page.keyboard.press("]");
  near((await state(page)).time, impacts[2].time, 1e-9, "next impact");
  await page.keyboard.press("[");
  near((await state(page)).time, impact.time, 1e-9, "previous impact");
  await page.close();
});

test("it plays, pauses, changes its speed and loops", async () => {
  const { page } = await openPage(browser, cradle.html);
  await page.selectOption(".transport select", "0.1");
  await page.click("#play");
  await until(page, () => window.rigor.playback.time > 0.02);
  await page.click("#play");
  const { time, isPlaying } = await state(page);
  assert.equal(isPlaying, false);
  await page.waitForTimeout(200);
  assert.equal((await state(page)).time, time);
  await page.keyboard.press("End");
  await page.keyboard.press(" ");
  await until(page, () => window.rigor.playback.isPlaying && window.rigor.playback.time < 0.5);
  await page.close();
});

test("the plots show the stored series", async () => {
  const { page } = await openPage(browser, cradle.html);
  const [time, kinetic] = await page.evaluate(() => window.rigor.plots.charts[0].data.map((column) => [...column]));
  assert.deepEqual(time, cradle.run.trajectory.map((row) => row.time));
  assert.deepEqual(kinetic, cradle.run.trajectory.map((row) => row.energy.kinetic));
  assert.equal(await page.locator(".plot canvas").count(), 4);
  // A chosen body gets its own.
  await page.click(".found button >> nth=2");
  const x = await page.evaluate(() => [...window.rigor.plots.charts[4].data[1]]);
  const { error } = await state(page);
  cradle.run.trajectory.forEach((row, k) => near(x[k], row.position[2][0], 1.01 * error, `x in frame ${k}`));
  await page.close();
});

test("a click on a body chooses it; search finds it; its numbers are shown", async () => {
  const { page } = await openPage(browser, cradle.html);
  await page.keyboard.press("/");
  await page.keyboard.type("ALL4");
  assert.equal(await page.locator(".found button").count(), 1);
  await page.click(".found button");
  assert.equal(await page.evaluate(() => window.rigor.selected), 3);
  await page.locator("#search").blur();
  // Followed, it is in the middle of the picture.
  await page.keyboard.press("f");
  await page.keyboard.press("Escape");
  assert.equal(await page.evaluate(() => window.rigor.selected), -1);
  await settle(page);
  const stage = await page.locator(".stage canvas").boundingBox();
  await page.mouse.click(stage.x + stage.width / 2, stage.y + stage.height / 2);
  await settle(page);
  assert.equal(await page.evaluate(() => window.rigor.selected), 3);
  assert.match(await page.locator("#numbers").innerText(), /ball4[\s\S]*velocity[\s\S]*kinetic energy[\s\S]*contacts/);
  await page.mouse.click(stage.x + 5, stage.y + 5);
  assert.equal(await page.evaluate(() => window.rigor.selected), -1);
  await page.close();
});

test("the audit is there as a table, and the help lists the keys", async () => {
  const { page } = await openPage(browser, cradle.html);
  await page.click("text=Audit");
  const text = await page.locator(".panel").innerText();
  assert.match(text, /audit passed/);
  assert.match(text, /events: impacts\s+4/);
  await page.keyboard.press("?");
  assert.match(await page.locator("dialog").innerText(), /play, pause/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("dialog[open]").count(), 0);
  await page.close();
});

test("contacts, velocities, frames, inertia and trails are drawn when asked for", async () => {
  const { html } = makePage("rocks", "--duration", "0.6");
  const { page, errors } = await openPage(browser, html);
  await page.keyboard.press("End");
  await settle(page);
  const arrows = () => page.evaluate(() => window.rigor.view.marks.arrows.geometry.instanceCount);
  const withContacts = await arrows();
  assert.ok(withContacts > 0);
  assert.ok(await page.evaluate(() => window.rigor.source.contactsAt(0.6).length) > 0);
  await page.keyboard.press("c");
  await settle(page);
  assert.equal(await arrows(), 0);
  for (const [key, least] of [["v", 1], ["x", 12], ["i", 24]]) {
    await page.keyboard.press(key);
    await settle(page);
    assert.ok((await arrows()) >= least, `${key}: ${await arrows()}`);
    await page.keyboard.press(key);
  }
  await page.keyboard.press("t");
  await settle(page);
  assert.ok(await page.evaluate(() => window.rigor.view.marks.trails.lines.visible));
  assert.deepEqual(errors, []);
  await page.close();
});

test("the deepest penetration of the run is found, and its bodies are marked", async () => {
  const rocks = makePage("rocks", "--duration", "0.6");
  const { page } = await openPage(browser, rocks.html);
  await page.keyboard.press("Shift+P");
  await settle(page);
  const { bodies, time } = rocks.run.audit.penetration;
  assert.ok(time > 0);
  near((await state(page)).time, time, 1e-9, "time");
  const marked = await page.evaluate(() => window.rigor.view.shapes.batches.flatMap(({ items, pose }) => items.flatMap(({ body }, i) => (pose.image.data[8 * i + 3] === 2 ? [body] : []))));
  // A plane has no shape to mark.
  const drawn = bodies.map((name) => rocks.run.bodies.indexOf(name)).filter((body) => rocks.run.bodies[body] !== "ground");
  assert.deepEqual([...new Set(marked)].sort(), drawn.sort());
  await page.close();
});

test("data that were cut or changed give a message that says so", async () => {
  const show = async (name, text) => {
    const { page, errors } = await openPage(browser, writePage(name, text));
    const words = await page.evaluate(() => document.body.innerText);
    assert.deepEqual(errors, [], name);
    const frames = await page.evaluate(() => window.rigor?.source.times.length);
    await page.close();
    return { words, frames };
  };
  const at = (kind) => cradle.text.indexOf(">", cradle.text.indexOf(`data-kind="${kind}"`)) + 1;
  const changed = (kind) => {
    // A character that stands for one group of bits and not for two, so that the block keeps its length.
    let i = at(kind) + 20;
    while (cradle.text.charCodeAt(i) >= 128) ++i;
    return cradle.text.slice(0, i) + (cradle.text[i] === "A" ? "B" : "A") + cradle.text.slice(i + 1);
  };
  assert.match((await show("header.html", changed("header"))).words, /cannot be shown[\s\S]*header block is damaged/);
  assert.match((await show("frames.html", changed("frames"))).words, /cannot be shown[\s\S]*frames block is damaged/);
  const contacts = await show("contacts.html", changed("contacts"));
  assert.match(contacts.words, /contacts block is damaged/);
  assert.equal(contacts.frames, cradle.run.trajectory.length);
  assert.match((await show("cut1.html", cradle.text.slice(0, at("header") + 100))).words, /cannot be shown[\s\S]*1 of \d+ data blocks[\s\S]*header block is cut/);
  assert.match((await show("cut2.html", cradle.text.slice(0, at("frames") + 50))).words, /cannot be shown[\s\S]*frames block is cut/);
  assert.match((await show("cut3.html", cradle.text.slice(0, at("contacts") + 4))).words, /contacts block is cut/);
  assert.match((await show("empty.html", cradle.text.slice(0, at("header") - 200))).words, /cannot be shown[\s\S]*no data blocks/);
});

test("a run that was cut shows the frames that are whole", async () => {
  const ball = makePage("bouncing_ball");
  const second = ball.text.indexOf('data-kind="frames"', ball.text.indexOf('data-kind="frames"') + 1);
  assert.ok(second > 0, "the run has more than one chunk");
  const { page } = await openPage(browser, writePage("half.html", ball.text.slice(0, second + 200)));
  assert.match(await page.evaluate(() => document.body.innerText), /the first 256 of \d+ frames are shown/);
  await page.keyboard.press("End");
  await settle(page);
  const { time, bodies, error } = await state(page);
  const row = ball.run.trajectory[255];
  assert.equal(time, row.time);
  const moving = ball.run.bodies.indexOf("ball");
  row.position[moving].forEach((x, c) => near(bodies[moving][c], x, 1.01 * error, "ball"));
  await page.close();
});

test("at the width of a phone nothing is wider than the screen, dark and light", async () => {
  for (const colorScheme of ["dark", "light"]) {
    const { page } = await openPage(browser, cradle.html, { viewport: { width: 390, height: 844 }, colorScheme });
    await settle(page);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    const dark = await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--is-dark").trim());
    assert.equal(dark, colorScheme === "dark" ? "1" : "0");
    await page.keyboard.press("d");
    const turned = await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--is-dark").trim());
    assert.notEqual(turned, dark);
    await page.close();
  }
});

test("the picture that is saved is that of the scene", async () => {
  const { page } = await openPage(browser, cradle.html);
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("s")]);
  assert.match(download.suggestedFilename(), /^cradle-.*s\.png$/);
  await page.close();
});

test("contact points are off where there are more than a few dozen, and come when asked for", async () => {
  const few = makePage("arch", "--duration", "0.3"), many = makePage("dominoes");
  for (const [run, expected] of [[few, true], [many, false]]) {
    const { page } = await openPage(browser, run.html);
    await settle(page);
    const most = await page.evaluate(() => window.rigor.source.mostContacts);
    assert.equal(most <= 36, expected, `${most} contacts`);
    const dots = () => page.evaluate(() => window.rigor.view.marks.dots.points.visible);
    assert.equal(await dots(), expected);
    await page.keyboard.press("c");
    await settle(page);
    assert.equal(await dots(), !expected);
    await page.close();
  }
});

test("forces are shown as a heat map when asked for, with the force of its hottest colour", async () => {
  const { html } = makePage("arch", "--duration", "0.3");
  const { page, errors } = await openPage(browser, html);
  await page.keyboard.press("End");
  await page.keyboard.press("m");
  await settle(page);
  await page.click("text=Show");
  assert.match(await page.locator(".heat-scale").innerText(), /\d+ N pressed on a body/);
  const warmth = await page.evaluate(() => window.rigor.view.shapes.batches.flatMap(({ items, pose }) => items.map((_, i) => pose.image.data[8 * i + 3])));
  assert.ok(warmth.filter((mark) => mark >= 4 && mark < 5).length > 3, `marks ${warmth}`);
  // The stones at the foot are pressed more than the key stone.
  assert.ok(Math.max(...warmth) > 4.9 && new Set(warmth).size > 3);
  await page.keyboard.press("m");
  await settle(page);
  assert.equal(await page.locator(".heat-scale").isVisible(), false);
  assert.deepEqual(errors, []);
  await page.close();
});

test("the camera looks over walls, and a wall that comes between turns to glass", async () => {
  const { html } = makePage("pile");
  const { page, errors } = await openPage(browser, html);
  await page.keyboard.press("End");
  await settle(page);
  const blocked = () => page.evaluate(() => window.rigor.view.sight.blocked(window.rigor.view.camera.position.toArray()));
  assert.equal(await blocked(), 0, "nothing hides what moves");
  // From the height of the walls, where one of them hides the boxes.
  await page.evaluate(() => {
    const { view } = window.rigor;
    view.camera.position.copy(view.controls.target);
    view.camera.position.x -= 4;
    view.camera.position.z = 0.3 - window.rigor.source.header.origin[2];
    view.controls.update();
  });
  await page.waitForTimeout(200);
  await page.evaluate(() => window.rigor.seek(1.5));
  await settle(page);
  const marks = await page.evaluate(() => window.rigor.view.shapes.batches.flatMap(({ items, pose }) => items.flatMap(({ body }, i) => (pose.image.data[8 * i + 3] === 3 ? [window.rigor.source.header.bodies[body].name] : []))));
  assert.ok(marks.includes("west"), `glass: ${marks}`);
  assert.ok(!marks.includes("east"), `what stands behind stays solid: ${marks}`);
  assert.deepEqual(errors, []);
  await page.close();
});

test("drawing that takes half a second does not slow time", async () => {
  const { page } = await openPage(browser, cradle.html);
  const [passed, played, frames] = await page.evaluate(() => new Promise((done) => {
    const { view, playback } = window.rigor;
    const draw = view.draw.bind(view);
    let frames = 0;
    view.draw = (...all) => {
      const until = performance.now() + 500;
      while (performance.now() < until);
      ++frames;
      draw(...all);
    };
    playback.speed = 0.1;
    window.rigor.toggle();
    // From the second picture on.
    const begin = () => {
      if (frames < 2) return requestAnimationFrame(begin);
      const [clock, time, before] = [performance.now(), playback.time, frames];
      const end = () => {
        if (frames - before < 4) return requestAnimationFrame(end);
        done([(performance.now() - clock) / 1000, (playback.time - time) / playback.speed, frames - before]);
      };
      requestAnimationFrame(end);
    };
    requestAnimationFrame(begin);
  }));
  assert.ok(passed / frames > 0.45, `${frames} pictures in ${passed} s`);
  // The replay stands where the last picture was: at most one picture behind the clock.
  near(played, passed, 1.2 * (passed / frames), "seconds played");
  await page.close();
});

test("Enter in the search chooses the first body that is found", async () => {
  const { page } = await openPage(browser, cradle.html);
  await page.keyboard.press("/");
  await page.keyboard.type("ball3");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => window.rigor.selected), 2);
  assert.equal(await page.locator('.found button[aria-pressed="true"]').innerText(), "ball3 dynamic");
  await page.close();
});

test("all plots show the values of the place where the pointer is, with their units", async () => {
  const { page } = await openPage(browser, cradle.html);
  const plot = await page.locator(".plot .u-over").first().boundingBox();
  await page.mouse.move(plot.x + 0.4 * plot.width, plot.y + 30);
  await settle(page);
  const shown = await page.evaluate(() => window.rigor.plots.charts.map((chart) => [chart.cursor.idx, chart.root.querySelector(".u-legend").innerText]));
  assert.equal(new Set(shown.map(([at]) => at)).size, 1, `rows ${shown.map(([at]) => at)}`);
  near(shown[0][0], 40, 2, "row under the pointer");
  assert.match(shown[0][1], /kinetic\s*[\d.]+ J/);
  assert.match(shown[1][1], /linear\s*[\d.]+ kg m\/s/);
  await page.close();
});

test("a film of the scene is a file to keep", async () => {
  const { page, errors } = await openPage(browser, cradle.html);
  const button = page.locator('[aria-label="Record a film of the scene"]');
  await button.click();
  await page.click("#play");
  await page.waitForTimeout(700);
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  assert.match(download.suggestedFilename(), /^cradle\.(webm|mp4)$/);
  assert.ok(statSync(await download.path()).size > 1000);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a body tells what it weighs and what holds it", async () => {
  const { page } = await openPage(browser, makePage("arch", "--duration", "0.3").html);
  await page.keyboard.press("End");
  await page.click(".found button >> nth=1");
  await settle(page);
  const numbers = await page.locator("#numbers").innerText();
  const weight = Number(/weight\s+([\d.]+) N/.exec(numbers)[1]);
  const mass = Number(/mass\s+([\d.]+) kg/.exec(numbers)[1]);
  near(weight, 9.81 * mass, 1e-3 * weight, "weight");
  assert.match(numbers, /held by\s+ground [\d.]+ N/);
  await page.close();
});

test("the keyboard reaches everything, and presses what it has reached", async () => {
  const { page } = await openPage(browser, cradle.html);
  await page.locator("#tab-0").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Show");
  assert.equal(await page.locator("#tab-1").getAttribute("aria-selected"), "true");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "show-contacts");
  await page.keyboard.press(" ");
  assert.equal(await page.evaluate(() => [window.rigor.shown.contacts, window.rigor.playback.isPlaying].join()), "false,false");
  await page.close();
});

/** Text that is smaller than 12 px, or whose colour is nearer than 4.5 : 1 to the one behind it. */
const unreadable = (page) => page.evaluate(() => {
  const numbers = (text) => (text.match(/[\d.]+/g) ?? [0, 0, 0, 0]).map(Number);
  const light = (c) => c.slice(0, 3).map((x) => x / 255).map((x) => (x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4)).reduce((sum, x, i) => sum + x * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const color = numbers(getComputedStyle(e).backgroundColor);
      if (color.length === 3 || color[3] > 0) return color;
    }
    return [255, 255, 255];
  };
  const found = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    if (!node.textContent.trim() || !element.checkVisibility() || element.closest("noscript, script") || element.disabled) continue;
    const style = getComputedStyle(element);
    const [a, b] = [light(numbers(style.color)), light(behind(element))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (parseFloat(style.fontSize) < 12 || contrast < 4.5) found.push(`${node.textContent.trim().slice(0, 30)}: ${style.fontSize}, ${contrast.toFixed(2)}`);
  }
  return found;
});

test("all text is at least 12 px high and stands out from what is behind it, dark and light", async () => {
  const { html } = makePage("arch", "--duration", "0.3");
  for (const colorScheme of ["dark", "light"]) {
    const { page } = await openPage(browser, html, { colorScheme });
    await page.click(".found button >> nth=2");
    for (const tab of [0, 1, 2]) {
      await page.click(`#tab-${tab}`);
      await settle(page);
      assert.deepEqual(await unreadable(page), [], `${colorScheme}, tab ${tab}`);
    }
    await page.close();
  }
});
