// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The package in Node.

import { readFile } from 'node:fs/promises';
import { Worker } from 'node:worker_threads';
import { make_skeletonize } from './skeletonize.js';

export const skeletonize = make_skeletonize({
  compile: async () => WebAssembly.compile(await readFile(new URL('cscd.wasm', import.meta.url))),
  start() {
    const worker = new Worker(new URL('node_worker.js', import.meta.url));
    worker.on('message', (data) => worker.onmessage({ data }));
    worker.on('error', (error) => worker.onerror(error));
    return worker;
  },
});
