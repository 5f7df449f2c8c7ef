// Makes pages with the program and opens them in a browser without a screen.
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { chromium } from "playwright-core";

const root = resolve(import.meta.dirname ?? new URL(".", import.meta.url).pathname, "../..");
const program = process.env.RIGOR ?? join(root, "build/release/rigor");
const folder = mkdtempSync(join(tmpdir(), "rigor-pages-"));

/** The browser: CHROMIUM, or where Debian's package puts it. Drawing is done in software. */
export async function openBrowser() {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  if (!existsSync(executablePath)) throw new Error(`no browser at ${executablePath}; install chromium or set CHROMIUM`);
  return chromium.launch({
    executablePath,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"],
  });
}

/** Runs a shipped scene; gives the page's file, its text and the same run as JSON. */
export function makePage(scene, ...options) {
  const name = [scene, ...options].join("_").replace(/[^a-z0-9_]/gi, "");
  const html = join(folder, `${name}.html`), json = join(folder, `${name}.json`);
  execFileSync(program, ["run", join(root, "scenes", `${scene}.yaml`), "-o", html, "-o", json, "--quiet", ...options], { stdio: ["ignore", "ignore", "ignore"] });
  return { html, text: readFileSync(html, "utf8"), run: JSON.parse(readFileSync(json, "utf8")) };
}

/** Compares runs of a scene; gives the page's file, its text and the comparison with all audits as JSON. */
export function makeComparison(scene, ...options) {
  const file = scene.endsWith(".yaml") ? scene : join(root, "scenes", `${scene}.yaml`);
  const name = `compare_${[basename(file, ".yaml"), ...options].join("_").replace(/[^a-z0-9_]/gi, "")}`;
  const html = join(folder, `${name}.html`), json = join(folder, `${name}.json`);
  // A run that stops or breaks its tolerance is worth a page too.
  spawnSync(program, ["compare", file, "-o", html, "--json", json, "--quiet", ...options], { stdio: "ignore" });
  return { html, text: readFileSync(html, "utf8"), table: JSON.parse(readFileSync(json, "utf8")) };
}

/** Waits until the page has drawn what was asked for. */
export const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));

export function writePage(name, text) {
  const file = join(folder, name);
  writeFileSync(file, text);
  return file;
}

/** Carries out a study of this text; gives its page's file, its own, and its runs as objects. */
export function makeStudy(name, text, ...options) {
  const file = join(folder, `${name}.yaml`), html = join(folder, `${name}.html`), csv = join(folder, `${name}.csv`);
  writeFileSync(file, text);
  execFileSync(program, ["study", file, "-o", html, "-o", csv, "--no-journal", "--quiet", ...options], { stdio: ["ignore", "ignore", "inherit"] });
  const [names, ...rows] = readFileSync(csv, "utf8").trim().split("\n").map((line) => line.split(","));
  return { file, html, rows: rows.map((row) => Object.fromEntries(names.map((column, i) => [column, row[i]]))) };
}

/** Starts `rigor study --view`; as serve(). */
export const serveStudy = (file) => started(["study", file, "--no-journal", "--quiet", "--view"]);

/** Starts `rigor view` with a file; gives its address and a function that ends it as Ctrl-C does. */
export const serve = (file) => started(["view", file]);

async function started(words) {
  const child = spawn(program, words, { stdio: ["ignore", "pipe", "inherit"] });
  const ended = new Promise((done) => child.on("exit", done));
  const url = await new Promise((found, failed) => {
    child.stdout.on("data", (text) => found(String(text).trim()));
    child.on("exit", (code) => failed(new Error(`rigor ${words[0]} ended with ${code}`)));
  });
  return { url, end: () => (child.kill("SIGINT"), ended) };
}

/** Opens a file; every error of the page's console is kept in `errors`. */
export function openPage(browser, file, options = {}) {
  return openAddress(browser, `file://${file}`, options);
}

/** Opens the page of a study. */
export const openStudy = (browser, address, options = {}) => openAddress(browser, address, options, "#runs canvas");

export async function openAddress(browser, address, options = {}, part = ".app, #message h1") {
  const page = await browser.newPage({ viewport: { width: 1000, height: 700 }, ...options });
  const errors = [];
  const requests = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(address);
  await page.waitForSelector(part, { timeout: 60000 });
  return { page, errors, requests };
}

export function removePages() {
  rmSync(folder, { recursive: true, force: true });
}
