// Makes dist/viewer.js and dist/study.js, each one script without imports, from src/. Same sources, same bytes.
import * as esbuild from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";

const version = (name) => JSON.parse(readFileSync(`node_modules/${name}/package.json`, "utf8")).version;
const notices = `Contains three.js ${version("three")} (MIT, Copyright 2010-2024 three.js authors)
and uPlot ${version("uplot")} (MIT, Copyright (c) 2022 Leon Sorokin); the full notices are in NOTICE.`;

async function bundle(source, target, banner) {
  const result = await esbuild.build({
    entryPoints: [source],
    bundle: true,
    minify: true,
    format: "iife",
    target: ["es2020"],
    charset: "ascii",
    legalComments: "none",
    loader: { ".css": "text" },
    banner: { js: banner },
    write: false,
  });
  const script = result.outputFiles[0].text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  writeFileSync(target, script);
  console.log(`${target}: ${script.length} bytes`);
}

await bundle("src/main.ts", "dist/viewer.js", `/*! Rigor viewer, Apache-2.0. ${notices} */`);
await bundle("src/study/main.ts", "dist/study.js", "/*! Rigor, page of a study, Apache-2.0. */");
