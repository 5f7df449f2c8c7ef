// Makes dist/viewer.js, one script without imports, from src/. Same sources, same bytes.
import * as esbuild from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";

const version = (name) => JSON.parse(readFileSync(`node_modules/${name}/package.json`, "utf8")).version;
const banner = `/*! Rigor viewer, Apache-2.0. Contains three.js ${version("three")} (MIT, Copyright 2010-2024 three.js authors)
and uPlot ${version("uplot")} (MIT, Copyright (c) 2022 Leon Sorokin); the full notices are in NOTICE. */`;

const result = await esbuild.build({
  entryPoints: ["src/main.ts"],
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
writeFileSync("dist/viewer.js", script);
console.log(`dist/viewer.js: ${script.length} bytes`);
