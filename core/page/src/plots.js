// Fuzzy matrices and bars of similarity, drawn as SVG. Colours come from the style sheet, so both schemes are served.

import { element } from "./numbers.js";

const COMPONENTS = ["Tx", "Ty", "Tz", "Rx", "Ry", "Rz"];
const WRENCH = ["fx", "fy", "fz", "mx", "my", "mz"];

function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function drawing(width, height, title) {
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", style: `max-width: ${width}px` }, svg("title", {}, title));
}

/// Degrees of membership, a row a component, a column a set.
function matrix(caption, degrees, rows, sets) {
  const cell = { width: Math.max(46, 8 * Math.max(...sets.map((name) => name.length)) + 6), height: 26 };
  const left = 34, top = 22;
  const picture = drawing(left + sets.length * cell.width + 2, top + degrees.length * cell.height + 2, caption);
  sets.forEach((name, k) => picture.append(svg("text", { x: left + (k + 0.5) * cell.width, y: 14, "text-anchor": "middle" }, name)));
  degrees.forEach((row, i) => {
    const y = top + i * cell.height;
    picture.append(svg("text", { x: left - 8, y: y + 17, "text-anchor": "end" }, rows[i]));
    row.forEach((degree, k) => {
      const x = left + k * cell.width;
      const box = svg("rect", { class: "degree", x: x + 1, y: y + 1, width: cell.width - 2, height: cell.height - 2, rx: 2, "fill-opacity": (0.04 + 0.96 * degree).toFixed(3) });
      box.append(svg("title", {}, `${rows[i]} is ${sets[k]} to the degree ${degree}`));
      picture.append(box);
      if (degree > 0) {
        picture.append(svg("text", { class: degree > 0.55 ? "on" : "", x: x + cell.width / 2, y: y + 17, "text-anchor": "middle" }, degree.toFixed(2)));
      }
    });
  });
  return element("figure", {}, picture, element("figcaption", { textContent: caption }));
}

/// A bar a component, from farthest to nearest of the measure over its six components.
function bars(report) {
  const { components, first } = report.result.similarity;
  const { first: name, first_nearest: nearest, first_farthest: farthest } = report.measures;
  const most = Math.max(...components, Math.abs(nearest - farthest) / 6);
  const left = 34, long = 300, step = 26;
  const caption = `Similarity of task and wrench, ${name} = ${first.toFixed(3)} (${nearest} is nearest, ${farthest} farthest)`;
  const picture = drawing(left + long + 70, 6 * step + 8, caption);
  components.forEach((value, k) => {
    const y = 4 + k * step;
    picture.append(svg("text", { x: left - 8, y: y + 17, "text-anchor": "end" }, COMPONENTS[k]));
    picture.append(svg("rect", { class: "track", x: left, y: y + 4, width: long, height: step - 8, rx: 2 }));
    if (value > 0) picture.append(svg("rect", { class: "bar", x: left, y: y + 4, width: (value / most) * long, height: step - 8, rx: 2 }));
    picture.append(svg("text", { x: left + long + 8, y: y + 17 }, value.toFixed(3)));
  });
  return element("figure", {}, picture, element("figcaption", { textContent: caption }));
}

export function showPlots(report, sets, place) {
  place.append(matrix(`Fuzzy task${report.task.name ? ` ${report.task.name}` : ""}`, report.fuzzy_task, COMPONENTS, sets));
  if (!report.result) return;
  place.append(matrix("Fuzzy wrench of the preshape", report.result.fuzzy_wrench, WRENCH, sets));
  place.append(bars(report));
}
