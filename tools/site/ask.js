/* Asks the site's search as a page does, without a browser: the theme's worker is given the index and questions, and must
   name the page first that explains the thing. Leaves with 1 if it does not.   usage: node tools/site/ask.js FOLDER */
"use strict";
const fs = require("fs"), path = require("path"), vm = require("vm");
const folder = process.argv[2];
const asked = {
  "solid.spacing": "scene.html#solid.spacing", "surface_correction": "scene.html#solid.surface_correction",
  "no memory left for": "troubleshooting.html", "permeability": "permeability.html", "glossary": "glossary.html",
  "theory": "theory.html", "time step": "choosing.html#steps",
  "python": "python.html", "slurm": "cluster.html", "image": "images.html", "mpich": "install.html#mpich-beside-open-mpi",
  "error against run time": "study.html",
};

const read = name => fs.readFileSync(path.join(folder, name), "utf8");
const worker = JSON.parse(/id="__config" type="application\/json">(.*?)<\/script>/s.exec(read("index.html"))[1]).search;
let listen, answer;
const self = {addEventListener: (_, f) => { listen = f; }, postMessage: m => { answer = m; }, location: {}};
const page = {location: {protocol: "http:"}};
vm.runInNewContext(read(worker), Object.assign(self, {self, console}));
vm.runInNewContext(read("search/search.js"), page);

async function ask(type, data) {
  answer = undefined;
  await listen({data: {type, data}});
  for (let i = 0; i < 600 && !answer; i++) await new Promise(r => setTimeout(r, 100));
  if (!answer) throw new Error("the search does not answer");
  return answer.data;
}

(async () => {
  const index = JSON.parse(read("search/search_index.json"));
  index.options = {pipeline: ["trimmer", "stopWordFilter"], suggestions: false};
  await ask(0, index);
  let missed = 0;
  for (const [question, wanted] of Object.entries(asked)) {
    const {items} = await ask(2, page.__search.transform(question));
    const first = (items[0] || []).map(e => e.location);
    if (first.includes(wanted)) continue;
    missed++;
    console.log(`the search for "${question}" should name ${wanted} first; it names ${first.join(", ") || "nothing"}`);
  }
  if (missed) process.exit(1);
  console.log(`${Object.keys(asked).length} questions are answered by the pages that they ask for`);
})().catch(e => { console.log(e); process.exit(1); });
