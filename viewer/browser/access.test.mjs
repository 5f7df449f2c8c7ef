// What axe-core, a program that looks for obstacles to keyboards and screen readers, finds on the three kinds of page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { makeComparison, makePage, openAddress, openBrowser, openPage, removePages, serve, settle, writePage } from "./pages.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const scene = `
rigor: 1
name: swing
run: {duration: 1}
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: -2}]}
  - {name: bob, position: [1, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1}]}
joints:
  - {name: pivot, type: hinge, bodies: [world, bob], anchor: [0, 0, 0], axis: [0, 1, 0]}
`;

let browser;
before(async () => (browser = await openBrowser()));
after(async () => {
  await browser?.close();
  removePages();
});

/** What axe finds on the page with each of its tabs open, one line a rule. */
async function findings(page) {
  await page.evaluate(axe);
  const found = [];
  for (const tab of await page.$$("[role=tab]")) {
    await tab.click();
    await settle(page);
    const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
    found.push(...violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 80)).join(" | ")}`));
  }
  return found;
}

/** Opens a page at the sizes of a desk and a phone, dark and light, and lets axe look at it. */
async function check(open) {
  for (const colorScheme of ["dark", "light"]) {
    for (const viewport of [{ width: 1280, height: 720 }, { width: 390, height: 844 }]) {
      const { page } = await open({ colorScheme, viewport, bypassCSP: true });
      assert.deepEqual(await findings(page), [], `${colorScheme}, ${viewport.width} px wide`);
      await page.close();
    }
  }
}

test("axe finds nothing on the page of a run, with a body chosen", async () => {
  const { html } = makePage("dominoes", "--duration", "0.1");
  await check(async (options) => {
    const opened = await openPage(browser, html, options);
    await opened.page.click(".found button >> nth=1");
    return opened;
  });
});

test("axe finds nothing on a page of several runs", async () => {
  const { html } = makeComparison("bouncing_ball_e09", "--vary", "run.step=0.02,0.01,0.005", "--duration", "1");
  await check((options) => openPage(browser, html, options));
});

test("axe finds nothing on the page of a live simulation", async () => {
  const server = await serve(writePage("swing.yaml", scene));
  await check((options) => openAddress(browser, server.url, options));
  await server.end();
});
