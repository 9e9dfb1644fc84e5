/* Typesets equations with KaTeX, all of one call at once. Reads a JSON array of {tex, display} from its standard input
   and writes one of the same length: {html, text}, with the text that the search shows, or {error}.
   usage: node tools/site/equations.js <EQUATIONS.json
          node tools/site/equations.js --style           prints the file of KaTeX's style sheet */
"use strict";
const fs = require("fs"), path = require("path");
const DEBIAN = "/usr/share/nodejs/katex"; // where its package is, which a node from elsewhere does not know

function place() {
  try {
    return require.resolve("katex");
  } catch {
    return require.resolve(DEBIAN);
  }
}
const katex = require(place());

function typeset({tex, display}) {
  try {
    const html = katex.renderToString(tex, {displayMode: display, throwOnError: true, strict: "error", trust: false});
    const text = /<math.*?<\/math>/s.exec(html)[0].replace(/<annotation.*?<\/annotation>/s, "").replace(/<[^>]*>/g, "");
    return {html, text};
  } catch (e) {
    return {error: e.message};
  }
}

if (process.argv[2] === "--style")
  process.stdout.write(path.join(path.dirname(place()), "katex.min.css"));
else
  process.stdout.write(JSON.stringify(JSON.parse(fs.readFileSync(0, "utf8")).map(typeset)));
