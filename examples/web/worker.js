// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletonizes and saves in a worker. Files live in the memory of the module. Each message is answered by one, with the
// messages of the program.

/* global make_cscd */
let ready = null;
let messages = [];

async function skeletonize({ cscd, name, bytes, detail }) {
  const { FS } = cscd;
  FS.writeFile(name, new Uint8Array(bytes));
  const begin = performance.now();
  const is_done = cscd.ccall('cscd_skeletonize', 'boolean', ['string', 'number'], [name, detail]);
  FS.unlink(name);
  if (!is_done) return {};
  const seconds = (performance.now() - begin) / 1000;
  return Object.assign({ seconds }, save({ cscd, option: 'html', name: 'page.html' }));
}

function save({ cscd, option, name }) {
  const path = '/saved/' + name;
  if (!cscd.ccall('cscd_save', 'boolean', ['string', 'string'], [option, path])) return {};
  const saved = cscd.FS.readFile(path);
  cscd.FS.unlink(path);
  return { saved };
}

onmessage = async ({ data }) => {
  if (data.wasm) {
    const say = (text) => messages.push(text);
    ready = make_cscd({ wasmBinary: data.wasm, print: say, printErr: say }).then((cscd) => {
      cscd.FS.mkdir('/saved');
      cscd.FS.mkdir('/input'); // messages call the file by its name alone
      cscd.FS.chdir('/input');
      return cscd;
    });
    return;
  }
  messages = [];
  let answer;
  try {
    const cscd = await ready;
    answer = await (data.option ? save : skeletonize)({ cscd, ...data });
  } catch (error) {
    answer = { is_broken: true };
    messages.push('gave up: ' + ((error && error.message) || error) + '; simplify the input, or use the program cscd');
  }
  postMessage({ ...answer, request: data, messages }, answer.saved ? [answer.saved.buffer] : []);
};
