// Bundles the page: node build.mjs NODE_MODULES OUTPUT. Style and script go into the template, whose places for a run
// stay as they are.
import { readFile, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const [modules, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(modules, "any.js"))("esbuild");

async function bundle(entry) {
  const result = await esbuild.build({
    entryPoints: [join(here, "src", entry)],
    nodePaths: [modules],
    bundle: true,
    minify: true,
    charset: "ascii",
    format: "iife",
    target: "es2022",
    legalComments: "none",
    write: false,
  });
  return result.outputFiles[0].text.trim();
}

const licence = await readFile(join(modules, "three", "LICENSE"), "utf8");
const script = (await bundle("main.js")).replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const style = await bundle("style.css");
const template = await readFile(join(here, "template.html"), "utf8");
const page = template
  .replace("/*style*/", () => style)
  .replace("/*script*/", () => `/* Contains three.js.\n${licence.trim()}\n*/\n${script}`);
await writeFile(output, page);
