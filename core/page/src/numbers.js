// The report as tables. Every number is a <data> whose value is the report's own, under its path in the JSON.

const COMPONENTS = ["Tx", "Ty", "Tz", "Rx", "Ry", "Rz"];
const WRENCH = ["fx", "fy", "fz", "mx", "my", "mz"];
const UNITS = { "": [1, 3], mm: [1e-3, 2], ms: [1e-3, 1], "cm\u00b3": [1e-6, 1], "\u00b0": [1, 1] };

export function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function at(report, path) {
  return path.split(".").reduce((value, key) => (value === null || value === undefined ? undefined : value[key]), report);
}

/// Whole numbers of these are measures, not counts, and are written as their neighbours are.
const MEASURED = /wrench|screw|normal_O|components|direction/;

const ROUNDING = 1e-8;  // of a unit: what is smaller is zero to a reader; the digits are in the title

/// The report's number at a path, in a unit. Small numbers keep three digits, but for lengths and measured components,
/// which are read beside their neighbours.
function number(report, path, unit = "") {
  const value = at(report, path);
  if (typeof value !== "number") return document.createTextNode(value === undefined || value === null ? "\u2013" : String(value));
  const [scale, decimals] = UNITS[unit];
  const shown = Math.abs(value / scale) < ROUNDING ? 0 : value / scale;
  let text = Number.isInteger(value) && unit === "" && !MEASURED.test(path) ? String(value) : shown.toFixed(decimals);
  if (shown !== 0 && Math.abs(shown) < 10 ** -decimals) {
    text = unit === "mm" || MEASURED.test(path) ? text.replace(/^-(?=[0.]+$)/, "") : shown.toPrecision(3);
  }
  const data = element("data", { value: String(value), textContent: text.replaceAll("-", "\u2212"), title: String(value) });
  data.dataset.path = path;
  data.dataset.unit = unit;
  return unit ? element("span", { className: "quantity" }, data, `\u00a0${unit}`) : data;
}

function text(report, path) {
  const value = at(report, path);
  if (typeof value === "boolean") return value ? "yes" : "no";
  return value === undefined || value === null || value === "" ? "\u2013" : String(value);
}

/// Rows of a name and what it has.
function facts(caption, rows) {
  const body = element("tbody"), most = Math.max(...rows.map((row) => row.length - 1));
  for (const [name, ...cells] of rows) {
    const row = element("tr", {}, element("th", { scope: "row", textContent: name }));
    cells.forEach((cell, i) => row.append(element("td", { colSpan: i === cells.length - 1 ? most - i : 1 }, cell)));
    body.append(row);
  }
  return table(caption, body);
}

/// Rows under named columns; the first cell of a row is its name.
function grid(caption, columns, rows) {
  const head = element("tr", {}, ...columns.map((name) => element("th", { scope: "col", textContent: name })));
  const body = element("tbody");
  for (const [name, ...cells] of rows) {
    body.append(element("tr", {}, element("th", { scope: "row", textContent: name }), ...cells.map((cell) => element("td", {}, cell))));
  }
  return table(caption, element("thead", {}, head), body);
}

function table(caption, ...parts) {
  const made = element("table", {}, element("caption", { textContent: caption }), ...parts);
  return element("div", { className: "table", tabIndex: 0, role: "region", ariaLabel: caption }, made);
}

function axes(report, path, unit = "") {
  return [0, 1, 2].map((k) => number(report, `${path}.${k}`, unit));
}

function preshape(report) {
  const n = (path, unit) => number(report, `result.${path}`, unit);
  const t = (path) => text(report, `result.${path}`);
  const rows = [
    ["Approach plane", element("span", {}, n("plane"), `: ${t("plane_text")}`)],
    ["Approach value x", n("approach_m", "mm")],
    ["\u2026 over the half extent", n("approach_fraction")],
    ["\u2026 as a symbol", t("approach_symbol_name")],
    ["Forefingers", n("virtual_fingers")],
    ["Taxonomy", `${t("taxonomy.opposition")}, ${t("taxonomy.grasp")}, ${t("taxonomy.type")}`],
    ["Opening", n("opening_m", "mm")],
    ["The hand opens wide enough", t("opens_wide_enough")],
    ["Depth", n("depth_m", "mm")],
    ["Stability", n("stability")],
    ["Manipulability", n("manipulability")],
    ["Confidence of recall", n("confidence")],
  ];
  return facts("Preshape", rows);
}

function contacts(report, base, caption) {
  const rows = at(report, base).contacts.map((contact, i) => [
    contact.finger, ...axes(report, `${base}.contacts.${i}.point_O_m`, "mm"), ...axes(report, `${base}.contacts.${i}.normal_O`),
  ]);
  return grid(caption, ["finger", "x", "y", "z", "normal x", "y", "z"], rows);
}

function wrenches(report) {
  const six = (path) => WRENCH.map((_, k) => number(report, `${path}.${k}`));
  const rows = report.result.contacts.map((contact, i) => [contact.finger, ...six(`result.contacts.${i}.wrench_C_O`)]);
  rows.push(["resultant about O", ...six("result.resultant_wrench")]);
  return grid("Wrenches, over the normal force and L", ["about", ...WRENCH], rows);
}

function screw(report) {
  return facts("Screw of the resultant", [
    ["Direction", ...axes(report, "result.screw.direction")],
    ["Point, over L", ...axes(report, "result.screw.point_normalised")],
    ["Pitch, over L", number(report, "result.screw.pitch_normalised")],
    ["Magnitude", number(report, "result.screw.magnitude")],
  ]);
}

function task(report) {
  const rows = COMPONENTS.map((name, k) => {
    const cells = [name, number(report, `task.screw.${k}`)];
    if (report.result) {
      cells.push(number(report, `result.resultant_wrench.${k}`), number(report, `result.similarity.components.${k}`));
    }
    return cells;
  });
  const columns = report.result ? ["component", "task", "wrench", `${report.measures.first}`] : ["component", "task"];
  return grid("Task and wrench", columns, rows);
}

function measures(report) {
  const rows = [["Stability wanted", number(report, "task.stability")], ["Manipulability wanted", number(report, "task.manipulability")]];
  if (report.result) {
    rows.push([`Similarity, ${report.measures.first}`, number(report, "result.similarity.first")]);
    rows.push([`Similarity, ${report.measures.second}`, number(report, "result.similarity.second")]);
    for (const name of Object.keys(report.result.quality)) rows.push([name.replaceAll("_", " "), number(report, `result.quality.${name}`)]);
  }
  for (const name of Object.keys(report.thresholds)) rows.push([`Threshold, ${name}`, number(report, `thresholds.${name}`)]);
  return facts("Measures and thresholds", rows);
}

function attempts(report) {
  const rows = report.attempts.map((attempt, i) => [
    `mode ${attempt.mode}`, attempt.rewarded ? "reward" : "penalty", number(report, `attempts.${i}.score`), attempt.words,
  ]);
  return grid("What was tried", ["mode", "critic", "score", "what came of it"], rows);
}

/// The space between the fingers of the open hand, and the way that it should come.
function approachVolume(report, base) {
  if (!at(report, base)) return [];
  return [
    ["Approach volume", number(report, `${base}.volume_m3`, "cm\u00b3")],
    ["\u2026 middle of its entrance", ...axes(report, `${base}.entrance_centroid_O_m`, "mm")],
    ["\u2026 normal there", ...axes(report, `${base}.entrance_normal_O`)],
    ["\u2026 off the approach axis", number(report, `${base}.angle_to_approach_deg`, "\u00b0")],
  ];
}

function simulation(report, base, caption) {
  const { reason } = at(report, base);
  return facts(caption, [
    ["Outcome", text(report, `${base}.status`).replaceAll("_", " ")],
    ...(reason ? [["Reason", reason]] : []),
    ["Largest distance of a fingertip", number(report, `${base}.contact_error_m`, "mm")],
    ["Free way of the open hand", number(report, `${base}.way_m`, "mm")],
    ["Hand base in O", ...axes(report, `${base}.hand_pose_O.p_m`, "mm")],
    ...approachVolume(report, `${base}.approach_volume`),
  ]);
}

/// The next-best stations, where the hand could not carry out the first.
function secondTry(report) {
  const other = (path, unit) => number(report, `second_try.result.${path}`, unit);
  const rows = [["Other stations tried", number(report, "second_try.attempts")]];
  if (report.second_try.result) {
    rows.push(["Carried out", element("span", {}, other("plane"), `: ${text(report, "second_try.result.plane_text")}`)]);
    rows.push(["\u2026 at x", other("approach_m", "mm")], ["\u2026 forefingers", other("virtual_fingers")]);
    rows.push([`\u2026 similarity, ${report.measures.first}`, other("similarity.first")]);
  } else rows.push(["Carried out", "none of them"]);
  return facts("Second try", rows);
}

function object(report) {
  return facts("Object and hand", [
    ["Object", report.object.name],
    ["Width, height, depth", ...axes(report, "object.extents_m", "mm")],
    ["Triangles", number(report, "object.triangles")],
    ["Watertight", text(report, "object.watertight")],
    ["Hand", report.pipeline.hand.name],
    ["Unit U", number(report, "pipeline.hand.unit_length_m", "mm")],
    ["Widest opening", number(report, "pipeline.hand.maximum_opening_m", "mm")],
  ]);
}

function components(report) {
  const rows = report.pipeline.components.map((use) => [use.role.replaceAll("_", " "), use.name, use.version]);
  return grid(`Components (preshape ${report.pipeline.preshape}, seed ${report.pipeline.seed})`, ["role", "component", "version"], rows);
}

function timings(report) {
  return facts("Time", Object.keys(report.timings).map((stage) => [stage, number(report, `timings.${stage}`, "ms")]));
}

/// The preshape in a line, and what became of it in the hand.
export function showSummary(report, place) {
  place.textContent = "No preshape was found.";
  if (!report.result) return;
  const { plane_text: plane, virtual_fingers: count, approach_m: x, similarity } = report.result;
  const fingers = `thumb and ${count} forefinger${count === 1 ? "" : "s"}`;
  const where = `x = ${(1000 * x).toFixed(1)}\u00a0mm`.replace("-", "\u2212");
  place.textContent = `${plane[0].toUpperCase()}${plane.slice(1)}, ${where}, ${fingers}; ${report.measures.first} ${similarity.first.toFixed(2)}. `;
  if (!report.simulation) return;
  const { status, reason } = report.simulation;
  const words = `Carried out by ${report.pipeline.hand.name}: ${status.replaceAll("_", " ")}${reason ? `, ${reason}` : ""}.`;
  place.append(element("span", { className: status === "reached" ? "good" : "bad", textContent: words }));
  const other = report.second_try?.result;
  if (other) place.append(` It carries out another station that serves: ${other.plane_text}, x = ${(1000 * other.approach_m).toFixed(1)}\u00a0mm.`.replace("= -", "= \u2212"));
}

export function showNumbers(report, place) {
  const result = report.result ? [preshape(report), contacts(report, "result", "Contacts, in O"), wrenches(report), screw(report)] : [];
  result.push(task(report), measures(report));
  if (report.simulation) result.push(simulation(report, "simulation", "Carried out by the hand"));
  if (report.second_try) result.push(secondTry(report));
  if (report.second_try?.result) {
    result.push(contacts(report, "second_try.result", "Contacts of the second try, in O"));
    result.push(simulation(report, "second_try.simulation", "Second try, carried out by the hand"));
  }
  const run = [attempts(report), object(report), components(report)];
  if (report.timings) run.push(timings(report));
  for (const [name, tables] of [["Result", result], ["Run", run]]) {
    place.append(element("h2", { textContent: name }), element("div", { className: "tables" }, ...tables));
  }
}
