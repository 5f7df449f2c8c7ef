// A page of several runs as a reader meets it: rigor compare -o compare.html.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { makeComparison, makePage, openBrowser, openPage, removePages, settle, writePage } from "./pages.mjs";

const values = ["0.9", "0.6", "0.3"];
const labels = values.map((value) => `materials.rubber.restitution=${value}`);
let browser;
let ball;
let alone;
before(async () => {
  browser = await openBrowser();
  ball = makeComparison("bouncing_ball_e09", "--vary", `materials.rubber.restitution=${values}`, "--duration", "2");
  alone = values.map((value) => makePage("bouncing_ball_e09", "--set", `materials.rubber.restitution=${value}`, "--duration", "2").run);
});
after(async () => {
  await browser?.close();
  removePages();
});

const near = (a, b, error, what) => assert.ok(Math.abs(a - b) <= error, `${what}: ${a} is not ${b} to ${error}`);
/** Heights of the ball as it is drawn in A and in B [m]; what the page stores is wrong by `error` at most. */
const heights = (page) => page.evaluate(() => {
  const { view, source, ghost } = window.rigor;
  const height = (motion, header) => motion.position[5] + header.origin[2];
  return { a: height(view.motion, source.header), b: ghost ? height(view.ghostMotion, ghost.header) : undefined, error: source.header.position_error };
});
const heightOf = (run, time) => run.trajectory.find((row) => Math.abs(row.time - time) < 1e-9).position[1][2];
const curves = (page) => page.evaluate(() => window.rigor.plots.charts.map(({ series, data }) => series.slice(1).map(({ label, dash, stroke }, i) => ({
  label, isDashed: Boolean(dash?.length), color: stroke(), values: [...data[i + 1]],
}))));

test("a page of several runs loads without console errors and asks for nothing else", async () => {
  const { page, errors, requests } = await openPage(browser, ball.html);
  await settle(page);
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, [`file://${ball.html}`]);
  assert.match(await page.locator("header").innerText(), /3 runs/);
  await page.close();
});

test("the reader chooses which run is solid and which is the ghost", async () => {
  const { page, errors } = await openPage(browser, ball.html);
  const check = async (a, b) => {
    await settle(page);
    const drawn = await heights(page);
    near(drawn.a, heightOf(alone[a], 1.5), 1.01 * drawn.error, "A");
    if (b === undefined) assert.equal(drawn.b, undefined);
    else near(drawn.b, heightOf(alone[b], 1.5), 1.01 * drawn.error, "B");
    assert.deepEqual(await page.evaluate(() => ["#run-a", "#run-b"].map((name) => Number(document.querySelector(name).value))), [a, b ?? -1]);
  };
  assert.deepEqual(await page.locator("#run-a option").allInnerTexts(), labels);
  assert.deepEqual(await page.locator("#run-b option").allInnerTexts(), ["none", ...labels]);
  await page.evaluate(() => window.rigor.seek(1.5));
  await check(0, 1);
  await page.selectOption("#run-b", "2");
  await check(0, 2);
  await page.selectOption("#run-a", "1");
  await check(1, 2);
  // What B is cannot be A as well: they change places.
  await page.selectOption("#run-a", "2");
  await check(2, 1);
  await page.click(".runs button");
  await check(1, 2);
  await page.selectOption("#run-b", "-1");
  await check(1, undefined);
  assert.deepEqual(errors, []);
  await page.close();
});

test("it opens on two runs that go different ways, and says why and from when on", async () => {
  // The order of runs: the first two differ in what changes no motion.
  const three = makeComparison("bouncing_ball_e09", "--vary", "materials.rubber.restitution=0.9,0.6", "--vary", "method.broad_phase=tree,sweep-and-prune", "--duration", "2");
  const { page, errors } = await openPage(browser, three.html);
  await settle(page);
  const [a, b] = await page.evaluate(() => ["#run-a", "#run-b"].map((name) => document.querySelector(name).selectedOptions[0].textContent));
  assert.match(a, /restitution=0\.9/);
  assert.match(b, /restitution=0\.6/);
  const why = await page.locator("#why").innerText();
  assert.match(why, /restitution=0\.6 instead of .*restitution=0\.9/);
  // The ball falls on the floor first, the same in both.
  const fall = alone[0].trajectory.flatMap((row) => row.events).find((event) => event.kind === "impact").time;
  const parted = Number(/part at ([\d.]+) s: ball/.exec(why)[1]);
  const interval = alone[0].trajectory[1].time;
  assert.ok(parted >= fall && parted <= fall + 2 * interval, `${parted} after ${fall}`);
  await page.selectOption("#run-b", "1");
  assert.match(await page.locator("#why").innerText(), /broad_phase=sweep-and-prune instead of .*No body goes another way/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("the time line has the impacts of A", async () => {
  const { page } = await openPage(browser, ball.html);
  const impacts = (run) => run.trajectory.flatMap((row) => row.events).filter((event) => event.kind === "impact");
  for (const run of [0, 2]) {
    await page.selectOption("#run-a", String(run));
    await page.keyboard.press("Home");
    await page.locator("#scrubber").focus();
    await page.keyboard.press("]");
    await page.keyboard.press("]");
    near(await page.evaluate(() => window.rigor.playback.time), impacts(alone[run])[1].time, 1e-8, `second impact of run ${run}`);
  }
  await page.close();
});

test("plots lay the same quantity of A and B over each other, or of all runs", async () => {
  const { page } = await openPage(browser, ball.html);
  const total = (run) => run.trajectory.map(({ energy }) => energy.kinetic + energy.potential + energy.elastic);
  let [energy, kinetic] = await curves(page);
  assert.deepEqual(energy.map(({ label }) => label), ["0.9", "0.6"]);
  assert.deepEqual(energy.map(({ isDashed }) => isDashed), [false, true]);
  assert.notEqual(energy[0].color, energy[1].color);
  energy.forEach((curve, i) => assert.deepEqual(curve.values, total(alone[i])));
  kinetic.forEach((curve, i) => assert.deepEqual(curve.values, alone[i].trajectory.map((row) => row.energy.kinetic)));
  assert.match(await page.locator(".plots-head").innerText(), /restitution=0\.9 \(A\)\s*materials\.rubber\.restitution=0\.6 \(B, dashed\)/);
  await page.check("#all-runs");
  [energy] = await curves(page);
  assert.deepEqual(energy.map(({ label }) => label), values);
  energy.forEach((curve, i) => assert.deepEqual(curve.values, total(alone[i])));
  assert.equal(new Set(energy.map(({ color }) => color)).size, 3);
  await page.uncheck("#all-runs");
  await page.selectOption("#run-a", "2");
  [energy] = await curves(page);
  assert.deepEqual(energy.map(({ label }) => label), ["0.6", "0.3"]);
  assert.deepEqual(energy.map(({ isDashed }) => isDashed), [true, false]);
  await page.close();
});

test("the chosen body has its plot in all runs and stays chosen when the runs change", async () => {
  const { page } = await openPage(browser, ball.html);
  await page.click(".found button >> nth=1");
  await page.keyboard.press("f");
  // The ball moves up and down: its z is shown first.
  assert.equal(await page.inputValue(".plot select"), "position/2");
  const check = async (runs) => {
    const plot = (await curves(page))[4];
    assert.deepEqual(plot.map(({ label }) => label), runs.map((run) => values[run]));
    const { error } = await heights(page);
    plot.forEach((curve, i) => alone[runs[i]].trajectory.forEach((row, k) => near(curve.values[k], row.position[1][2], 1.01 * error, `frame ${k}`)));
  };
  await check([0, 1]);
  await page.selectOption("#run-b", "2");
  await check([0, 2]);
  assert.equal(await page.evaluate(() => window.rigor.selected), 1);
  assert.equal(await page.evaluate(() => window.rigor.view.followed), 1);
  await page.selectOption(".plot select", "velocity/0");
  assert.ok((await curves(page))[4].every(({ values: own }) => own.every((v) => v === 0)));
  await page.close();
});

test("the audits stand side by side, and what differs is marked", async () => {
  const { page } = await openPage(browser, ball.html);
  const rows = await page.locator(".audits tbody tr").evaluateAll((all) => all.map((row) => ({
    name: row.querySelector("th").innerText,
    cells: [...row.querySelectorAll("td")].map((cell) => ({ text: cell.innerText, differs: cell.classList.contains("differs") })),
  })));
  const row = (name) => rows.find((candidate) => candidate.name === name);
  assert.deepEqual(await page.locator(".audits thead th").allInnerTexts(), values);
  const impacts = ball.table.runs.map(({ audit }) => String(audit.events.impacts));
  assert.notEqual(impacts[0], impacts[1]);
  assert.deepEqual(row("≠ events: impacts").cells.map(({ text }) => text), impacts);
  assert.deepEqual(row("≠ events: impacts").cells.map(({ differs }) => differs), impacts.map((count) => count !== impacts[0]));
  assert.ok(row("method: scheme").cells.every(({ text, differs }) => text === "event-driven" && !differs));
  assert.ok(row("ended").cells.every(({ text }) => text === "✓ audit passed"));
  // Outcomes come first; settings that are equal are folded away until they are asked for.
  const order = rows.map(({ name }) => name);
  assert.ok(order.indexOf("≠ events: impacts") < order.indexOf("method: scheme"));
  assert.ok(!(await page.locator(".audits tr", { hasText: "method: scheme" }).isVisible()));
  await page.click("#equal-settings");
  assert.ok(await page.locator(".audits tr", { hasText: "method: scheme" }).isVisible());
  await page.check("#only-differences");
  assert.ok(await page.locator(".audits tr", { hasText: "events: impacts" }).isVisible());
  assert.ok(!(await page.locator(".audits tr", { hasText: "method: scheme" }).isVisible()));
  // The panel has the audit of A.
  await page.click(".tabs >> text=Audit");
  assert.match(await page.locator(".panel").innerText(), new RegExp(`events: impacts\\s+${impacts[0]}\\b`));
  await page.selectOption("#run-a", "2");
  assert.match(await page.locator(".panel").innerText(), new RegExp(`events: impacts\\s+${impacts[2]}\\b`));
  await page.close();
});

test("a run that stopped says so and stands still while the others go on", async () => {
  const file = writePage("piston.yaml", `rigor: 1
name: piston
method: {scheme: event-driven}
run: {duration: 2, output_interval: 0.01}
world: {gravity: [0, 0, 0]}
materials: [{name: m, restitution: 0, friction: 0}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: m}]}
  - {name: ball, position: [0, 0, 0.5], mass: 1, velocity: [0, 0, -1], shapes: [{type: sphere, radius: 0.1, material: m}]}
  - {name: piston, motion: kinematic, position: [0, 0, 2], velocity: [0, 0, -1], shapes: [{type: box, size: [1, 1, 1], material: m}]}
`);
  const piston = makeComparison(file, "--vary", "bodies.piston.velocity=[0, 0, -1],[0, 0, -0.1]");
  assert.deepEqual(piston.table.runs.map(({ end }) => end), ["stopped", "ok"]);
  const { page, errors } = await openPage(browser, piston.html);
  await page.keyboard.press("End");
  await settle(page);
  assert.equal(await page.evaluate(() => window.rigor.playback.time), 2);
  // The fast piston stands where it met the ball: its lower face 0.2 m above the floor. The slow one came down by 0.2 m.
  const places = await page.evaluate(() => [window.rigor.view.motion, window.rigor.view.ghostMotion].map((motion, i) => motion.position[8] + [window.rigor.source, window.rigor.ghost][i].header.origin[2]));
  near(places[0], 0.7, 1e-3, "fast piston");
  near(places[1], 1.8, 1e-3, "slow piston");
  assert.match(await page.locator(".runs").innerText(), /stopped at 1\.3 s/);
  assert.match(await page.locator(".audits").innerText(), /✗ stopped: .*\s+✓ audit passed/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a page whose one run is damaged shows the others", async () => {
  const at = ball.text.indexOf(">", ball.text.indexOf('data-run="1" data-kind="frames"')) + 20;
  const damaged = ball.text.slice(0, at) + (ball.text[at] === "A" ? "B" : "A") + ball.text.slice(at + 1);
  const { page, errors } = await openPage(browser, writePage("damaged.html", damaged));
  assert.match(await page.locator(".problem").first().innerText(), /run 2: the frames block is damaged/);
  assert.deepEqual(await page.locator("#run-a option").allInnerTexts(), [labels[0], labels[2]]);
  assert.deepEqual(errors, []);
  await page.close();
});

test("eight runs have eight colours; changing runs again and again keeps the scene drawn", async () => {
  const many = makeComparison("cradle", "--vary", "run.seed=1,2,3,4,5,6,7,8");
  const { page, errors } = await openPage(browser, many.html);
  await page.check("#all-runs");
  const [energy] = await curves(page);
  assert.equal(new Set(energy.map(({ color }) => color)).size, 8);
  const geometries = () => page.evaluate(() => window.rigor.view.renderer.info.memory.geometries);
  await settle(page);
  const before = await geometries();
  for (let i = 0; i < 24; ++i) {
    await page.evaluate((run) => window.rigor.showRuns({ a: run % 8, b: (run + 3) % 8 }), i);
    await settle(page);
  }
  // What is not drawn any more is given back to the graphics card.
  assert.ok((await geometries()) <= before, `${await geometries()} geometries instead of ${before}`);
  assert.deepEqual(errors, []);
  await page.close();
});

test("at the width of a phone nothing is wider than the screen, dark and light", async () => {
  for (const colorScheme of ["dark", "light"]) {
    const { page } = await openPage(browser, ball.html, { viewport: { width: 390, height: 844 }, colorScheme });
    await page.click(".found button >> nth=1");
    await page.check("#all-runs");
    await settle(page);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    await page.close();
  }
});

test("runs of several steps are plotted as work and precision, on logarithmic axes", async () => {
  const pendulum = makeComparison("pendulum", "--vary", "method.integrator=rk4,midpoint", "--vary", "run.step=0.01,0.005,0.0025", "--duration", "1");
  const { page, errors } = await openPage(browser, pendulum.html);
  await settle(page);
  assert.deepEqual(errors, []);
  const plots = page.locator(".precision svg");
  assert.equal(await plots.count(), 2);
  assert.deepEqual(await page.locator(".precision .plot h2").allInnerTexts(), ["Error over CPU time", "Error over step"]);
  assert.deepEqual(await page.locator(".precision .legend > span").allInnerTexts(), ["method.integrator=rk4", "method.integrator=midpoint"]);
  assert.match(await page.locator(".precision > h2").innerText(), /event-driven, integrator exact, step 0.05 s/);
  const circles = await plots.nth(1).locator("circle").evaluateAll((all) => all.map((circle) => ({
    x: Number(circle.getAttribute("cx")), y: Number(circle.getAttribute("cy")), text: circle.textContent })));
  assert.equal(circles.length, 6);
  // Half the step is the same way to the left each time, and a smaller error is lower down, by the order of the method.
  const [a, b, c] = circles;
  near(a.x - b.x, b.x - c.x, 1e-6, "a halving");
  assert.ok(a.y < b.y && b.y < c.y, "errors of rk4 fall");
  near((c.y - b.y) / (circles[5].y - circles[4].y), 2, 0.2, "order 4 over order 2");
  assert.match(b.text, /run.step=0.005: error .* m, step 0.005 s, CPU time .* s, observed order /);
  const words = await plots.nth(0).locator("text").allTextContents();
  for (const word of ["CPU time [s]", "error [m]"]) assert.ok(words.includes(word), word);
  await page.close();
});
