// A live simulation as a reader meets it: `rigor view` and its page in Chromium.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openAddress, openBrowser, removePages, serve, writePage } from "./pages.mjs";

const scene = (height) => `
rigor: 1
name: live
world: {gravity: [0, 0, -9.81]}
run: {duration: 1, output_interval: 0.01}
materials: [{name: rubber, restitution: 0.5, friction: 0.2}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, ${height}], mass: 1, shapes: [{type: sphere, radius: 0.1, material: rubber}]}
`;
const ball = 1;

let browser;
let server;
before(async () => {
  browser = await openBrowser();
  server = await serve(writePage("live.yaml", scene(1)));
});
after(async () => {
  await browser?.close();
  await server?.end();
  removePages();
});

async function until(page, isTrue, argument) {
  for (let tries = 0; tries < 500; ++tries) {
    // While the page loads itself again there is nothing to ask.
    if (await page.evaluate(isTrue, argument).catch(() => false)) return;
    await page.waitForTimeout(20);
  }
  assert.fail(`never true: ${isTrue}`);
}
const time = (page) => page.evaluate(() => window.rigor.source.time);
const place = (page) => page.evaluate((body) => window.rigor.positionOf(body), ball);
async function open(options) {
  const opened = await openAddress(browser, server.url, options);
  await until(opened.page, () => window.rigor?.status !== undefined);
  return opened;
}
async function reset(page) {
  await page.evaluate(() => window.rigor.send({ do: "pause" }));
  await page.evaluate(() => window.rigor.send({ do: "reset" }));
  await until(page, () => !window.rigor.status.running && window.rigor.source.time === 0);
}

test("the live page runs, pauses and steps, without console errors and without other addresses", async () => {
  const { page, errors, requests } = await open();
  await reset(page);
  await page.click("#run");
  await until(page, () => window.rigor.source.time > 0.1);
  await page.click("#run");
  await until(page, () => !window.rigor.status.running);
  await page.waitForTimeout(200);
  const paused = await time(page);
  await page.waitForTimeout(300);
  assert.equal(await time(page), paused);
  await page.keyboard.press("ArrowRight");
  await until(page, (before) => window.rigor.source.time > before, paused);
  assert.ok((await time(page)) - paused <= 0.01 + 1e-9);
  assert.deepEqual(errors, []);
  const own = new URL(server.url).origin;
  for (const request of requests) assert.ok(request.startsWith(own) || request.startsWith("blob:"), request);
  await page.close();
});

test("the gravity slider lets the ball float", async () => {
  const { page } = await open();
  await reset(page);
  await page.locator("#gravity").fill("0");
  await until(page, () => window.rigor.status.gravity.every((g) => Math.abs(g) === 0));
  await page.click("#run");
  await until(page, () => window.rigor.source.time > 0.2);
  await page.click("#run");
  await page.waitForTimeout(200);
  assert.ok(Math.abs((await place(page))[2] - 1) < 1e-5);
  await page.locator("#gravity").fill("9.81");
  await until(page, () => window.rigor.status.gravity[2] < -9.8);
  await page.close();
});

test("dragging with Shift pulls the ball, letting go ends the pull", async () => {
  const { page, errors } = await open();
  await reset(page);
  await page.keyboard.press("r");
  await page.waitForTimeout(300);
  const canvas = await page.locator(".stage canvas").boundingBox();
  const [x, y] = await page.evaluate((body) => {
    const { view } = window.rigor;
    const at = view.camera.position.clone().fromArray(view.motion.position, 3 * body).project(view.camera);
    return [(at.x + 1) / 2, (1 - at.y) / 2];
  }, ball);
  await page.keyboard.down("Shift");
  await page.mouse.move(canvas.x + x * canvas.width, canvas.y + y * canvas.height);
  await page.mouse.down();
  await page.mouse.move(canvas.x + x * canvas.width + 60, canvas.y + y * canvas.height - 30, { steps: 6 });
  await page.keyboard.press(" ");
  // Held up, it goes sideways and does not fall on the floor.
  await until(page, () => window.rigor.source.time > 1);
  const held = await place(page);
  assert.ok(Math.hypot(held[0], held[1]) > 0.01, `went aside: ${held}`);
  assert.ok(held[2] > 0.5, `is held up: ${held}`);
  await page.mouse.up();
  await page.keyboard.up("Shift");
  await until(page, (body) => window.rigor.positionOf(body)[2] < 0.3, ball);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a click chooses the ball, a drag pulls it without any other key, also behind a wall", async () => {
  const walled = await serve(writePage("walled.yaml", `${scene(1)}  - {name: wall, motion: static, position: [0, -0.5, 1], shapes: [{type: box, size: [4, 0.1, 4], material: rubber}]}\n`));
  const { page, errors } = await openAddress(browser, walled.url);
  await until(page, () => window.rigor?.status !== undefined);
  // From behind the wall, which hides the ball.
  await page.evaluate(() => {
    const { view } = window.rigor;
    view.camera.position.copy(view.controls.target);
    view.camera.position.y -= 5;
    view.controls.update();
  });
  // On a busy machine the page is laid out and drawn late: the click is repeated where the ball is then.
  let px = 0, py = 0;
  for (let tries = 0; tries < 10; ++tries) {
    await page.waitForTimeout(400);
    const canvas = await page.locator(".stage canvas").boundingBox();
    const [x, y] = await page.evaluate((body) => {
      const { view } = window.rigor;
      const at = view.camera.position.clone().fromArray(view.motion.position, 3 * body).project(view.camera);
      return [(at.x + 1) / 2, (1 - at.y) / 2];
    }, ball);
    [px, py] = [canvas.x + x * canvas.width, canvas.y + y * canvas.height];
    await page.mouse.click(px, py);
    await page.waitForTimeout(100);
    if (await page.evaluate((body) => window.rigor.selected === body, ball)) break;
  }
  await until(page, (body) => window.rigor.selected === body, ball);
  await page.mouse.move(px, py);
  await page.mouse.down();
  await page.mouse.move(px + 60, py - 20, { steps: 6 });
  await page.keyboard.press(" ");
  await until(page, () => window.rigor.source.time > 1);
  const held = await place(page);
  assert.ok(held[2] > 0.5 && Math.hypot(held[0], held[1]) > 0.01, `is held: ${held}`);
  await page.mouse.up();
  assert.deepEqual(errors, []);
  await page.close();
  await walled.end();
});

test("it goes a step back in time, and on from there", async () => {
  const { page } = await open();
  await reset(page);
  const height = () => page.evaluate((body) => window.rigor.source.newest.position[3 * body + 2], ball);
  const heights = [await height()];
  for (let k = 1; k <= 3; ++k) {
    await page.keyboard.press("ArrowRight");
    await until(page, (t) => Math.abs(window.rigor.source.time - t) < 1e-9, 0.01 * k);
    heights.push(await height());
  }
  for (let k = 2; k >= 0; --k) {
    await page.keyboard.press("ArrowLeft");
    await until(page, (t) => Math.abs(window.rigor.source.time - t) < 1e-9, 0.01 * k);
    assert.ok(Math.abs(await height() - heights[k]) < 1e-6, `height at ${k}`);
  }
  await until(page, () => window.rigor.status.earlier === 0);
  await page.keyboard.press("ArrowRight");
  await until(page, () => Math.abs(window.rigor.source.time - 0.01) < 1e-9);
  assert.ok(Math.abs(await height() - heights[1]) < 1e-6);
  await page.close();
});

test("a motor of a joint is set by its slider, and let go", async () => {
  const hinged = await serve(writePage("hinged.yaml", `
rigor: 1
name: hinged
world: {gravity: [0, 0, 0]}
run: {duration: 1, output_interval: 0.01}
materials: [{name: steel}]
bodies:
  - {name: wheel, position: [0, 0, 1], mass: 1, shapes: [{type: cylinder, radius: 0.5, length: 0.1, material: steel}]}
joints:
  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 0, 1], axis: [0, 0, 1]}
`));
  const { page, errors } = await openAddress(browser, hinged.url);
  await until(page, () => window.rigor?.status !== undefined);
  await page.locator("#motor-0").fill("2");
  await until(page, () => Math.abs(window.rigor.status.axes[0].motor - 2) < 1e-9);
  assert.ok(await page.isChecked("#motor-on-0"));
  await page.keyboard.press("Escape");
  await page.click("#run");
  await until(page, () => window.rigor.source.time > 0.3);
  assert.ok(Math.abs((await page.evaluate(() => window.rigor.view.motion.spin[2])) - 2) < 1e-4);
  await page.uncheck("#motor-on-0");
  await until(page, () => window.rigor.status.axes[0].motor === null);
  assert.deepEqual(errors, []);
  await page.close();
  await hinged.end();
});

test("a hit acts where the body was clicked", async () => {
  const { page } = await open();
  await reset(page);
  await page.keyboard.press("r");
  await page.waitForTimeout(300);
  const canvas = await page.locator(".stage canvas").boundingBox();
  // Half a radius beside the middle; how far from the middle the line of sight passes there.
  const [x, y, arm] = await page.evaluate(([body, width, height]) => {
    const { view } = window.rigor;
    const center = [...view.motion.position.subarray(3 * body, 3 * body + 3)];
    const place = (shift) => {
      const right = view.camera.position.clone().setFromMatrixColumn(view.camera.matrixWorld, 0).multiplyScalar(shift);
      const at = right.add(view.camera.position.clone().fromArray(center)).project(view.camera);
      return [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height];
    };
    const [px, py] = place(0.05).map(Math.round);
    const { from, direction: d } = view.rayAt(px, py);
    const r = center.map((c, i) => c - from[i]);
    const cross = [r[1] * d[2] - r[2] * d[1], r[2] * d[0] - r[0] * d[2], r[0] * d[1] - r[1] * d[0]];
    return [px, py, Math.hypot(...cross)];
  }, [ball, canvas.width, canvas.height]);
  await page.locator("#gravity").fill("0");
  await until(page, () => window.rigor.status.gravity.every((g) => Math.abs(g) === 0));
  await page.mouse.move(canvas.x + x, canvas.y + y);
  await page.keyboard.down("Alt");
  await page.mouse.down();
  await page.mouse.up();
  await page.keyboard.up("Alt");
  await page.waitForTimeout(300);
  const [speed, spin] = await page.evaluate((body) => {
    const { motion } = window.rigor.view;
    return [motion.velocity, motion.spin].map((all) => Math.hypot(...all.subarray(3 * body, 3 * body + 3)));
  }, ball);
  // 1 kg gets 2 m/s; the ball's moment of inertia is 0.4 m r² with r = 0.1 m.
  assert.ok(Math.abs(speed - 2) < 1e-3, `speed ${speed}`);
  assert.ok(arm > 0.02 && arm < 0.08, `arm ${arm}`);
  assert.ok(Math.abs(spin - (2 * arm) / 0.004) < 1e-3 * spin, `spin ${spin}, arm ${arm}`);
  await page.locator("#gravity").fill("9.81");
  await until(page, () => window.rigor.status.gravity[2] < -9.8);
  await page.close();
});

test("plots and time line show what happened since the reset, a click on a tick its impulse", async () => {
  const { page, errors } = await open();
  await reset(page);
  await page.evaluate(() => window.rigor.select(1));
  await page.click("#run");
  await until(page, () => window.rigor.source.time > 0.8);
  await page.click("#run");
  await until(page, () => !window.rigor.status.running);
  await until(page, () => window.rigor.source.times[window.rigor.source.times.length - 1] > window.rigor.source.time - 0.02);
  // The plot of the body follows the newest frame with the other numbers, a moment later.
  await until(page, () => {
    const times = window.rigor.plots.charts[4].data[0];
    return times[times.length - 1] === window.rigor.source.time;
  });
  const { titles, data, height } = await page.evaluate(() => ({
    titles: [...document.querySelectorAll(".plot h2")].map((title) => title.firstChild.textContent),
    data: window.rigor.plots.charts.map((chart) => chart.data.map((column) => [...column])),
    height: window.rigor.positionOf(1)[2],
  }));
  assert.deepEqual(titles, ["Energy", "Momentum", "Deepest penetration", "Solver effort an interval", "ball"]);
  const [times, , potential] = data[0];
  assert.ok(Math.abs(potential[0] - 9.81) < 1e-9, "m g h at the start");
  assert.ok(times.every((t, k) => Math.abs(t - 0.01 * k) < 1e-9), "each output time once");
  const [own, , , z] = data[4];
  assert.ok(own[own.length - 1] > 0.8 && Math.abs(z[z.length - 1] - height) < 1e-6, "the chosen body up to now");
  // It falls 0.9 m and bounces with 0.5: 1.5 m √(2 g h), at √(2 h / g).
  const impact = await page.evaluate(() => window.rigor.source.events[0]);
  assert.ok(Math.abs(impact.time - Math.sqrt(1.8 / 9.81)) < 1e-6);
  const line = await page.locator("#scrubber").boundingBox();
  await page.mouse.click(line.x + (line.width * impact.time) / times[times.length - 1], line.y + 15);
  await page.locator("#event").waitFor();
  const text = await page.locator("#event").innerText();
  assert.match(text, /impact at 0\.428/);
  assert.match(text, new RegExp(`impulse\\s+${(1.5 * Math.sqrt(2 * 9.81 * 0.9)).toFixed(3)}`));
  await reset(page);
  await until(page, () => window.rigor.source.events.length === 0 && window.rigor.source.times.length === 1);
  assert.equal(await page.locator("#event").isVisible(), false, "after a reset there was no impact");
  assert.deepEqual(errors, []);
  await page.close();
});

test("state and page come as files", async () => {
  const { page } = await open();
  for (const [name, pattern] of [["Save state", /^live-.*\.checkpoint$/], ["Export page", /^live-.*\.html$/]]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`text=${name}`)]);
    assert.match(download.suggestedFilename(), pattern);
  }
  await page.close();
});

test("a file that is broken gives its messages, one that is mended a new scene", async () => {
  const { page } = await open();
  writePage("live.yaml", scene(1).replace("mass: 1", "mass: -1"));
  await page.locator("#file .warning").waitFor();
  assert.match(await page.locator("#file").innerText(), /live\.yaml:\d+.*mass/);
  writePage("live.yaml", scene(3));
  await until(page, (body) => window.rigor?.status !== undefined && window.rigor.source.header.bodies[body].start.p[2] === 3, ball);
  await page.close();
});

test("at the width of a phone nothing is wider than the screen", async () => {
  const { page } = await open({ viewport: { width: 390, height: 844 } });
  await page.evaluate(() => window.rigor.select(1));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await page.close();
});
