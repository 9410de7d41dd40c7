// What a page does when it is opened. The report is the same JSON as `--json` writes (docs/report-schema.md).
import { showNumbers, showSummary } from "./numbers.js";
import { showPlots } from "./plots.js";
import { showScene } from "./scene.js";

const json = (id) => JSON.parse(document.getElementById(id).textContent);

function save(name, type, data) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([data], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const report = json("report");
const glb = Uint8Array.from(atob(document.getElementById("glb").textContent), (c) => c.charCodeAt(0));

document.getElementById("title").textContent = document.title;
const verdict = document.getElementById("verdict");
verdict.textContent = report.verdict.toLowerCase().startsWith(report.status) ? report.verdict : `${report.status}: ${report.verdict}`;
verdict.className = report.served ? "good" : "bad";
showSummary(report, document.getElementById("summary"));
showNumbers(report, document.getElementById("numbers"));
showPlots(report, json("set-names"), document.getElementById("drawn"));
document.getElementById("save-scene").onclick = () => save("scene.glb", "model/gltf-binary", glb);
document.getElementById("save-report").onclick = () => save("report.json", "application/json", JSON.stringify(report, null, 2) + "\n");

// For tests and scripts: "drawn", or why there is no picture; the tables stand either way.
showScene(glb.buffer, report)
  .then(() => { document.documentElement.dataset.scene = "drawn"; })
  .catch((problem) => {
    document.documentElement.dataset.scene = `failed: ${problem.message}`;
    document.getElementById("scene").classList.add("absent");
    document.getElementById("pointed").textContent = "This browser cannot draw the scene (it has no WebGL); every number is in the tables.";
  });
