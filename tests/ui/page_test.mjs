// Opens pages of real runs in headless Chromium: node page_test.mjs PRESHAPE CHROMIUM. With a third argument, a folder,
// screenshots are left there. It ends with 0, or 1 after a line for each thing that is wrong.
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser, Page } from "./browser.mjs";
import { difference, readPng } from "./png.mjs";

const [preshape, chromium, pictures] = process.argv.slice(2);
if (!existsSync(join(dirname(preshape), "../share/preshape/page/template.html"))) {
  console.log("page_test skipped: this build has no page template (the npm registry could not be reached)");
  process.exit(0);
}
const folder = await mkdtemp(join(tmpdir(), "preshape_page_"));
let checks = 0, wrong = 0, seconds = 0;

function check(true_, what) {
  ++checks;
  if (true_) return;
  ++wrong;
  console.log(`WRONG: ${what}`);
}

/// A page of a run, and its numbers as --json has them.
async function run(name, settings, more = []) {
  const script = join(folder, "run.lua"), page = join(folder, `${name}.html`), json = join(folder, `${name}.json`);
  await writeFile(script, "return preshape.scenario { object = 'cube', task = 'T1_2', memory = ':memory:' }\n");
  const options = settings.flatMap((setting) => ["--set", setting]);
  try {
    execFileSync(preshape, ["run", script, "-q", "--page", page, "--json", json, ...options, ...more], { stdio: ["ignore", "ignore", "inherit"] });
  } catch (problem) {
    if (![3, 4].includes(problem.status)) throw problem;  // not served, deadlock: these have a page too
  }
  return { url: pathToFileURL(page).href, report: JSON.parse(await readFile(json, "utf8")), size: (await readFile(page)).length };
}

const at = (value, path) => path.split(".").reduce((inner, key) => inner?.[key], value);

const SCALES = { "": 1, mm: 1e-3, ms: 1e-3, "cm\u00b3": 1e-6, "\u00b0": 1 };

/// The numbers of the tables are the report's: the value to the last digit, the words to those that are shown.
async function checkNumbers(page, report, name) {
  const told = await page.ask(`[...document.querySelectorAll("data")].map((d) => ({ path: d.dataset.path, unit: d.dataset.unit, value: d.value, text: d.textContent }))`);
  for (const { path, unit, value, text } of told) {
    const number = at(report, path), shown = Number(text.replaceAll("\u2212", "-"));
    check(Number(value) === number, `${name}: ${path} is ${number} in the report and ${value} on the page`);
    const digits = (text.split("e")[0].split(".")[1] ?? "").length, power = Number(text.split("e")[1]?.replace("\u2212", "-") ?? 0);
    const half = 0.5001 * 10 ** (power - digits);
    check(Math.abs(shown - number / SCALES[unit]) <= half, `${name}: ${path} is ${number} in the report and "${text} ${unit}" on the page`);
  }
  const paths = new Set(told.map(({ path }) => path));
  const wanted = ["task.stability", "thresholds.estimation", "thresholds.recognition", "timings.controller", "object.triangles",
    ...[0, 1, 2, 3, 4, 5].map((k) => `task.screw.${k}`)];
  if (report.result) {
    wanted.push("result.approach_m", "result.similarity.first", "result.stability", "result.screw.magnitude");
    wanted.push(...[0, 1, 2, 3, 4, 5].map((k) => `result.resultant_wrench.${k}`));
    report.result.contacts.forEach((_, i) => wanted.push(`result.contacts.${i}.point_O_m.2`, `result.contacts.${i}.wrench_C_O.5`));
  }
  for (const [key, value] of [["simulation", report.simulation], ["second_try.simulation", report.second_try?.simulation]]) {
    if (value?.approach_volume) wanted.push(...["volume_m3", "entrance_centroid_O_m.0", "entrance_normal_O.2", "angle_to_approach_deg"].map((k) => `${key}.approach_volume.${k}`));
  }
  if (report.second_try?.result) wanted.push("second_try.result.contacts.1.point_O_m.0", "second_try.simulation.contact_error_m");
  for (const path of wanted) check(paths.has(path), `${name}: ${path} is not on the page`);
  const told_json = await page.ask(`document.getElementById("report").textContent`);
  check(JSON.stringify(JSON.parse(told_json)) === JSON.stringify(report), `${name}: the report in the page is not that of --json`);
  const words = await page.ask(`document.getElementById("verdict").textContent`);
  check(words.includes(report.verdict) && words.toLowerCase().includes(report.status), `${name}: the verdict reads "${words}"`);
}

async function view(page) {
  const clip = await page.ask(`(() => { const r = document.getElementById("view").getBoundingClientRect(); return { x: r.x, y: r.y + scrollY, width: Math.floor(r.width), height: Math.floor(r.height) }; })()`);
  await page.ask(`new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(() => drawn(true))))`);
  return readPng(await page.screenshot({ clip }));
}

const toggle = (label) => `(() => { const l = [...document.querySelectorAll("#shown label")].find((l) => l.textContent.trim() === ${JSON.stringify(label)}); if (!l) return false; l.firstChild.click(); return true; })()`;

/// The scene is drawn, each switch changes the picture, and it comes back.
async function checkScene(page, report, name) {
  const first = await view(page);
  await page.ask(`document.getElementById("canvas").style.visibility = "hidden"`);
  const ground = await view(page);
  await page.ask(`document.getElementById("canvas").style.visibility = ""`);
  const share = difference(first, ground);
  check(share > 0.02, `${name}: only ${(100 * share).toFixed(2)} % of the view differ from its background`);
  const labels = report.result ? ["see through the object", "contacts", "normals", "wrenches", "plane and axes"] : ["see through the object"];
  if (report.simulation?.approach_volume) labels.push("approach volume");
  if (report.simulation) labels.unshift("hand");
  let before = first;
  for (const label of labels) {  // one after the other: a fingertip may hide its contact
    check(await page.ask(toggle(label)), `${name}: there is no switch "${label}"`);
    const after = await view(page);
    check(difference(before, after) > 0, `${name}: "${label}" changes nothing`);
    before = after;
  }
  for (const label of labels) await page.ask(toggle(label));
  check(difference(first, await view(page)) === 0, `${name}: switched back, the scene is not as it was`);
  await page.ask(`document.getElementById("canvas").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }))`);
  check(difference(first, await view(page)) > 0.005, `${name}: the arrow keys do not turn the view`);
  await page.ask(`document.getElementById("reset").click()`);
  check(difference(first, await view(page)) === 0, `${name}: the view is not reset`);
}

/// The slider goes to the open hand, and Play from there to the grasp.
async function checkMotion(page, report, name) {
  const hidden = await page.ask(`document.getElementById("motion").hidden`);
  check(hidden === !(report.simulation?.path.length > 1), `${name}: the motion is ${hidden ? "not " : ""}offered`);
  if (hidden) return;
  const grasp = await view(page);
  await page.ask(`(() => { const t = document.getElementById("time"); t.value = 0; t.dispatchEvent(new Event("input")); })()`);
  check(difference(grasp, await view(page)) > 0.001, `${name}: the slider does not move the hand`);
  await page.ask(`document.getElementById("play").click()`);
  await page.until(`document.getElementById("play").textContent === "Play"`);
  check(difference(grasp, await view(page)) === 0, `${name}: the motion does not end in the grasp`);
}

/// Which try is seen, and what collides in it, are said in words; both are found in the scene that is drawn.
async function checkShown(page, report, name, first) {
  const second = report.second_try?.result, result = second && !first ? second : report.result;
  const words = await page.ask(`(() => { const p = document.getElementById("shown-try"); return p.hidden ? "" : p.textContent; })()`);
  const x = result && `${result.approach_fraction < 0 ? "\u2212" : "+"}${Math.abs(result.approach_fraction).toFixed(2)}`;
  seconds += second ? 1 : 0;
  const wanted = second ? `Shown is the ${first ? "first" : "second"} try: plane ${result.plane}, x = ${x} of the half extent.` : "";
  check(words === wanted, `${name}: what is shown reads "${words}", not "${wanted}"`);
  const legend = await page.ask(`[...document.querySelectorAll("#legend li")].map((l) => l.textContent).join("; ")`);
  const simulation = second && !first ? report.second_try.simulation : report.simulation;
  check(legend.includes("collides: ") === (simulation?.status === "collision"), `${name}: the legend reads "${legend}"`);
  const link = simulation?.status === "collision" && /link (\d+) of the (\w+)/.exec(simulation.reason);
  if (link) check(legend.includes(`${link[2]} link ${link[1]}`), `${name}: "${simulation.reason}", but the legend reads "${legend}"`);
}

async function checkPage(browser, name, settings, window, more = []) {
  const { url, report, size } = await run(name, settings, more);
  check(size < 2e6, `${name}: the page has ${size} bytes`);
  const page = await Page.open(browser, url, window);
  const state = await page.ask(`document.documentElement.dataset.scene`);
  check(state === "drawn", `${name}: the scene is not drawn: ${state}`);
  check((await page.ask(`document.documentElement.scrollWidth`)) <= window.width, `${name}: the page is wider than its window`);
  await checkNumbers(page, report, name);
  if (pictures) await writeFile(join(pictures, `${name}.png`), await page.screenshot());
  if (state === "drawn") {
    await checkScene(page, report, name);
    await checkMotion(page, report, name);
    await checkShown(page, report, name, more.includes("--first-try"));
  }
  check(page.complaints.length === 0, `${name}: the console says ${page.complaints.join("; ")}`);
  const others = page.requests.filter((address) => address !== url && !/^(data|blob):/.test(address));
  check(others.length === 0, `${name}: the page asks for ${others.join(", ")}`);
  await page.close();
}

/// Where nothing can be drawn in three dimensions, the numbers stand and the page says what is missing.
async function checkWithoutScene(browser, name) {
  const { url, report } = await run(name, ["object=cube"]);
  const page = await Page.open(browser, url, { width: 1280, height: 800 });
  const state = await page.ask(`document.documentElement.dataset.scene`);
  check(state.startsWith("failed: "), `${name}: the scene is said to be "${state}"`);
  const words = await page.ask(`document.getElementById("pointed").textContent`);
  check(words.includes("every number is in the tables"), `${name}: the page says "${words}"`);
  await checkNumbers(page, report, name);
  if (pictures) await writeFile(join(pictures, `${name}.png`), await page.screenshot());
  await page.close();
}

let browser;
try {
  browser = await Browser.open(chromium);
  const wide = { width: 1280, height: 800 }, narrow = { width: 400, height: 800 };
  await checkPage(browser, "sphere", ["object=sphere"], wide);
  await checkPage(browser, "mug_dark", ["object=mug"], { ...narrow, dark: true });
  await checkPage(browser, "box_without_hand", ["object=box", "simulator=none"], narrow);
  await checkPage(browser, "deadlock", ["object=box", "thresholds={ estimation = 6, recognition = 6 }"], wide);
  await checkPage(browser, "first_try", ["object=mug"], wide, ["--first-try"]);
  check(seconds > 0, "no run had a second try that was carried out; choose an object that has");
  await browser.close();
  browser = await Browser.open(chromium, ["--disable-3d-apis"]);
  await checkWithoutScene(browser, "without_scene");
} catch (problem) {
  check(false, problem.stack);
} finally {
  await browser?.close();
  await rm(folder, { recursive: true, force: true });
}
console.log(`${checks} checks, ${wrong} wrong`);
process.exitCode = wrong === 0 && checks > 0 ? 0 : 1;
