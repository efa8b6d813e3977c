// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opens, shows, and saves files.

import { bytes_of_base64, download } from '../../viewer/bytes.js';

window.cscd.state = 'empty'; // tests wait for it

// Endings of files, the option of the program that writes them, and their content.
const formats = [
  ['.graph', 'output', 'nodes and edges'],
  ['.json', 'output', 'nodes, edges, branches'],
  ['.obj', 'output', 'polylines'],
  ['.polylines.txt', 'output', 'polylines as CGAL’s'],
  ['.ply', 'output', 'nodes, radii, edges'],
  ['.swc', 'output', 'for tools of neurons'],
  ['.vtp', 'output', 'for ParaView'],
  ['.glb', 'output', 'rig of the mesh'],
  ['_branches.csv', 'branches', 'table of branches'],
  ['_nodes.csv', 'nodes', 'table of nodes'],
  ['_vertices.csv', 'correspondence', 'node of each vertex'],
  ['_report.json', 'report', 'counts, times, warnings'],
  ['.html', 'output', 'this view as a page'],
];
const text_of = (id) => document.getElementById(id).textContent.trim();
const element = (id) => document.getElementById(id);
const brings_files = (event) => [...event.dataTransfer.types].includes('Files');
let worker = null;
let file = null;
let waiting = null;

function start_worker() {
  const source = new Blob([text_of('glue'), '\n', text_of('worker')], { type: 'text/javascript' });
  worker = new Worker(URL.createObjectURL(source));
  worker.onmessage = ({ data }) => answered(data);
  worker.onerror = (event) => answered({ request: {}, is_broken: true, messages: ['gave up: ' + event.message] });
  worker.postMessage({ wasm: bytes_of_base64(text_of('wasm')) });
}

function say(text, is_error) {
  for (const id of ['status', 'start_status']) {
    element(id).textContent = text;
    element(id).classList.toggle('error', Boolean(is_error));
  }
}

function set_state(state) {
  window.cscd.state = state;
  const is_busy = state === 'computing';
  element('save').disabled = state !== 'done';
  element('detail').disabled = is_busy;
  clearInterval(waiting);
  if (!is_busy) return;
  const begin = performance.now();
  const tell = () =>
    say(`Computing the skeleton of ${file.name} … ${((performance.now() - begin) / 1000).toFixed(0)} s`);
  tell();
  waiting = setInterval(tell, 1000);
}

// A file that is opened while another is computed takes its place.
async function compute() {
  if (window.cscd.state === 'computing') stop_worker();
  set_state('computing');
  const bytes = await file.arrayBuffer();
  if (!worker) start_worker();
  worker.postMessage({ name: file.name, bytes, options: { detail: element('detail').value } }, [bytes]);
}

function open_file(chosen) {
  file = chosen;
  compute();
}

function stop_worker() {
  if (worker) worker.terminate();
  worker = null;
}

function answered({ request, saved, seconds, messages, is_broken }) {
  if (is_broken) stop_worker();
  const said = messages.map((text) => text.replace(/^cscd: /, '')).join('\n');
  if (!saved) {
    say(said, true);
    if (!request.option || is_broken) set_state('failed'); // else there is a skeleton, which this format cannot hold
  } else if (request.option) {
    const is_page = request.name.endsWith('.html');
    download(new Blob([is_page ? with_three_js(new TextDecoder().decode(saved)) : saved]), request.name);
  } else {
    window.cscd.seconds = seconds;
    show(new TextDecoder().decode(saved));
    say([`${file.name}: ${seconds.toFixed(1)} s`, said].filter(Boolean).join('\n'));
    set_state('done');
  }
}

// three.js is here once; pages that the module writes have a mark in its place.
function with_three_js(page) {
  const mark = 'CSCD_THREE_JS';
  const at = page.indexOf(`\n${mark}\n`) + 1;
  return page.slice(0, at) + text_of('three_js') + page.slice(at + mark.length);
}

function show(page) {
  const viewer = element('viewer');
  viewer.onload = () => viewer.contentWindow.addEventListener('dragenter', enter); // on the picture, too
  viewer.srcdoc = with_three_js(page);
  viewer.hidden = element('bar').hidden = false;
  element('drop').hidden = true;
}

function drag(is_over) {
  element('drop').classList.toggle('over', is_over);
  element('card').hidden = !element('viewer').hidden;
  element('drop').hidden = !is_over && !element('viewer').hidden;
}

function enter(event) {
  if (brings_files(event)) drag(true);
}

for (const button of document.querySelectorAll('.open'))
  button.addEventListener('click', () => element('file').click());
element('file').addEventListener('change', () => {
  if (element('file').files.length > 0) open_file(element('file').files[0]);
  element('file').value = ''; // so that the same file can be chosen again
});
for (const [ending, , content] of formats) element('format').add(new Option(`${ending} — ${content}`, ending));
element('detail').addEventListener('input', () => {
  element('detail').nextElementSibling.textContent = element('detail').value;
});
element('detail').addEventListener('change', () => compute());
element('save').addEventListener('click', () => {
  const [ending, option] = formats.find((format) => format[0] === element('format').value);
  worker.postMessage({ option, name: file.name.replace(/\.[^.]*$/, '') + ending });
});
window.addEventListener('dragover', (event) => event.preventDefault());
window.addEventListener('dragenter', enter);
window.addEventListener('dragleave', (event) => {
  if (!event.relatedTarget) drag(false);
});
window.addEventListener('drop', (event) => {
  event.preventDefault();
  drag(false);
  if (event.dataTransfer.files.length > 0) open_file(event.dataTransfer.files[0]);
});
