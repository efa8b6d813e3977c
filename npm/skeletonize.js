// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The calls of the package. The differences between Node and browsers are in node.js and browser.js.

// The options of the program that apply, and the type of their values.
const option_types = {
  detail: 'number',
  seed: 'number',
  borders: 'string',
  shape: 'string',
  root: 'any',
  minComponent: 'number',
  join: 'boolean',
  separators: 'number',
};

const to_program = (name) => name.replace(/[A-Z]/g, (letter) => '-' + letter.toLowerCase());
const to_camel_case = (name) => name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

// The options as the program takes them: names of its command line, values as text.
function to_options(given) {
  const result = {};
  for (const [name, value] of Object.entries(given)) {
    const type = option_types[name];
    if (!type) {
      const names = [...Object.keys(option_types), 'signal', 'onProgress'].join(', ');
      throw new RangeError(`${name}: is not an option; use one of ${names}`);
    }
    if (value === undefined) continue;
    if (type !== 'any' && typeof value !== type) {
      throw new TypeError(`${name}: must be a ${type}, not ${JSON.stringify(value)}`);
    }
    result[to_program(name)] = String(value);
  }
  return result;
}

function check_triples(name, array, content) {
  if (!array || array.length === undefined || array.length % 3 !== 0) {
    throw new TypeError(`${name}: must be an array of ${content}, three each`);
  }
}

function check_indices(indices, number_of_vertices) {
  const is_wrong = (index) => !(Number.isInteger(index) && index >= 0 && index < number_of_vertices);
  const wrong = Array.prototype.findIndex.call(indices, is_wrong);
  if (wrong !== -1) {
    throw new RangeError(
      `indices: number ${wrong} is ${indices[wrong]}; use vertices from 0 to ${number_of_vertices - 1}`,
    );
  }
}

// The message of the program, with the options as they are called here.
function to_message(messages) {
  const text = messages.map((line) => line.replace(/^cscd: /, '')).join('\n');
  return text.replace(/--([a-z-]+)/g, (_, name) => to_camel_case(name));
}

// compile() gives a promise of the WebAssembly.Module, start() a worker with the interface of browsers.
export function make_skeletonize({ compile, start }) {
  let compiled = null; // once, for all calls

  return async function skeletonize(positions, indices, { signal, onProgress, ...given } = {}) {
    const options = to_options(given);
    check_triples('positions', positions, 'coordinates');
    if (indices) {
      check_triples('indices', indices, 'vertices of triangles');
      check_indices(indices, positions.length / 3);
    }
    const input = { positions: new Float64Array(positions), indices: new Uint32Array(indices ?? []), options };
    signal?.throwIfAborted();
    compiled ??= compile();
    const wasm = await compiled.catch((error) => {
      compiled = null;
      throw error;
    });
    signal?.throwIfAborted();
    const worker = start();
    let abort = null;
    try {
      return await new Promise((resolve, reject) => {
        abort = () => reject(signal.reason);
        signal?.addEventListener('abort', abort);
        worker.onerror = (event) => reject(new Error('the worker gave up: ' + event.message));
        worker.onmessage = ({ data }) => {
          try {
            if (data.stage) onProgress(data.stage, data.fraction);
            else if (data.skeleton) resolve(data.skeleton);
            else reject(new Error(to_message(data.messages)));
          } catch (error) {
            reject(error);
          }
        };
        worker.postMessage({ wasm });
        worker.postMessage({ ...input, wants_progress: Boolean(onProgress) }, [
          input.positions.buffer,
          input.indices.buffer,
        ]);
      });
    } finally {
      signal?.removeEventListener('abort', abort);
      worker.terminate(); // gives its memory back
    }
  };
}
