// Asks the yaml language server (npm install yaml-language-server) for the mistakes of scenes by a schema. Prints them;
// exit code 1 if a good scene has one, or a bad one none.
// usage: node language_server.js SERVER SCHEMA.json GOOD.yaml... [--bad BAD.yaml...]
'use strict';
const {spawn} = require('child_process');
const fs = require('fs');
const path = require('path');
const [server, schema, ...rest] = process.argv.slice(2);
const at = rest.indexOf('--bad');
const good = at < 0 ? rest : rest.slice(0, at), bad = at < 0 ? [] : rest.slice(at + 1);
const uri = file => 'file://' + path.resolve(file);
const child = spawn(server, ['--stdio'], {stdio: ['pipe', 'pipe', 'inherit']});
const found = new Map();
let held = Buffer.alloc(0);

function send(message) {
  const text = JSON.stringify({jsonrpc: '2.0', ...message});
  child.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
}

const settings = {
  yaml: {validate: true, hover: true, schemaStore: {enable: false}, schemas: {[uri(schema)]: '*.yaml'}},
  http: {},
  '[yaml]': {}
};

function take(message) {
  if (message.id !== undefined && message.method) { // the server asks
    const items = message.params && message.params.items;
    send({id: message.id, result: items ? items.map(i => settings[i.section] || {}) : null});
  } else if (message.id === 0) {
    send({method: 'initialized', params: {}});
    send({method: 'workspace/didChangeConfiguration', params: {settings}});
    for (const file of [...good, ...bad]) {
      const text = fs.readFileSync(file, 'utf8');
      send({method: 'textDocument/didOpen', params: {textDocument: {uri: uri(file), languageId: 'yaml', version: 1, text}}});
    }
  } else if (message.method === 'textDocument/publishDiagnostics') {
    found.set(message.params.uri, message.params.diagnostics);
    if ([...good, ...bad].every(f => found.has(uri(f)))) setTimeout(end, 2000); // a later answer replaces an earlier one
  }
}

function end() {
  let wrong = 0;
  for (const file of good)
    for (const d of found.get(uri(file))) {
      console.log(`${file}:${d.range.start.line + 1}: ${d.message}`);
      wrong++;
    }
  for (const file of bad) {
    const its = found.get(uri(file));
    console.log(`${file}: ${its.length ? 'refused: ' + its[0].message : 'NOT REFUSED'}`);
    wrong += its.length ? 0 : 1;
  }
  console.log(`${good.length} good scenes, ${bad.length} bad ones, ${wrong} wrong`);
  child.kill();
  process.exit(wrong ? 1 : 0);
}

child.stdout.on('data', data => {
  held = Buffer.concat([held, data]);
  for (;;) {
    const head = held.indexOf('\r\n\r\n');
    if (head < 0) return;
    const length = Number(/Content-Length: (\d+)/.exec(held.toString('utf8', 0, head))[1]);
    if (held.length < head + 4 + length) return;
    take(JSON.parse(held.toString('utf8', head + 4, head + 4 + length)));
    held = held.subarray(head + 4 + length);
  }
});
child.on('exit', code => { if (code) process.exit(code); });
const capabilities = {workspace: {configuration: true}, textDocument: {publishDiagnostics: {}}};
send({id: 0, method: 'initialize', params: {processId: process.pid, rootUri: null, capabilities}});
