// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletonizes and saves in a worker, for the page and for the npm package. Files live in the memory of the module. Each
// message except the first is answered by one, with the messages of the program; progress comes before, if it is wanted.

/* global make_cscd */
const time_between_progress = 50; // milliseconds
let ready = null;
let messages = [];
let tell_progress = null;

function skeletonize_file({ cscd, name, bytes, options }) {
  const { FS } = cscd;
  FS.writeFile(name, new Uint8Array(bytes));
  const begin = performance.now();
  const lines = Object.entries(options).map(([option, value]) => `${option} ${value}\n`);
  const is_done = cscd.ccall('cscd_skeletonize', 'boolean', ['string', 'string'], [name, lines.join('')]);
  FS.unlink(name);
  return is_done && { seconds: (performance.now() - begin) / 1000 };
}

function open({ cscd, ...request }) {
  const done = skeletonize_file({ cscd, ...request });
  return done ? Object.assign(done, save({ cscd, option: 'output', name: 'page.html' })) : {};
}

function save({ cscd, option, name }) {
  const path = '/saved/' + name;
  if (!cscd.ccall('cscd_save', 'boolean', ['string', 'string'], [option, path])) return {};
  const saved = cscd.FS.readFile(path);
  cscd.FS.unlink(path);
  return { saved };
}

// A file in binary PLY, which keeps all digits. Numbers of this machine are little-endian, as those of WebAssembly.
function ply_of(positions, indices) {
  const number_of_faces = indices.length / 3;
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${positions.length / 3}\n${'xyz'.replace(
    /./g,
    'property double $&\n',
  )}element face ${number_of_faces}\nproperty list uchar uint vertex_indices\nend_header\n`;
  const size_of_face = 1 + 3 * Uint32Array.BYTES_PER_ELEMENT;
  const bytes = new Uint8Array(header.length + positions.byteLength + number_of_faces * size_of_face);
  bytes.set(new TextEncoder().encode(header));
  bytes.set(new Uint8Array(positions.buffer), header.length);
  const view = new DataView(bytes.buffer);
  let at = header.length + positions.byteLength;
  for (let face = 0; face < number_of_faces; ++face, at += size_of_face) {
    bytes[at] = 3;
    for (let k = 0; k < 3; ++k) view.setUint32(at + 1 + 4 * k, indices[3 * face + k], true);
  }
  return bytes;
}

function skeletonize_arrays({ cscd, positions, indices, options }) {
  const name = indices.length > 0 ? 'mesh' : 'points'; // for messages
  const bytes = ply_of(positions, indices);
  if (!skeletonize_file({ cscd, name, bytes, options: { ...options, format: 'ply' } })) return {};
  const json = (option) => JSON.parse(new TextDecoder().decode(save({ cscd, option, name: 'skeleton.json' }).saved));
  const { nodes, edges } = json('output');
  const first = cscd.ccall('cscd_nodes_of_vertices', 'number', [], []) / Int32Array.BYTES_PER_ELEMENT;
  return {
    skeleton: {
      nodes: Float64Array.from(nodes.flatMap(({ point }) => point)),
      radii: Float64Array.from(nodes, ({ radius }) => radius),
      edges: Uint32Array.from(edges.flat()),
      vertexToNode: cscd.HEAP32.slice(first, first + positions.length / 3),
      report: json('report'),
    },
  };
}

// Passes a stage on when it begins, and then at times.
function make_progress() {
  let last_stage = '';
  let last = 0;
  return (stage, fraction) => {
    const now = performance.now();
    if (stage === last_stage && now - last < time_between_progress) return;
    [last_stage, last] = [stage, now];
    postMessage({ stage, fraction });
  };
}

globalThis.onmessage = async ({ data }) => {
  if (data.wasm) {
    const say = (text) => messages.push(text);
    ready = make_cscd({
      print: say,
      printErr: say,
      on_progress: (...progress) => tell_progress?.(...progress),
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(data.wasm, imports).then((result) => receive(result.instance ?? result));
        return {};
      },
    }).then((cscd) => {
      cscd.FS.mkdir('/saved');
      cscd.FS.mkdir('/input'); // messages call the file by its name alone
      cscd.FS.chdir('/input');
      return cscd;
    });
    return;
  }
  messages = [];
  tell_progress = data.wants_progress ? make_progress() : null;
  let answer;
  try {
    const cscd = await ready;
    answer = (data.option ? save : data.positions ? skeletonize_arrays : open)({ cscd, ...data });
  } catch (error) {
    answer = { is_broken: true };
    messages.push('gave up: ' + ((error && error.message) || error) + '; simplify the input, or use the program cscd');
  }
  const { option, name } = data;
  postMessage({ ...answer, request: { option, name }, messages }, answer.saved ? [answer.saved.buffer] : []);
};
