// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gives a worker of Node the interface of workers in browsers.

import { parentPort } from 'node:worker_threads';

globalThis.postMessage = (...answer) => parentPort.postMessage(...answer);
await import('./worker.js');
parentPort.on('message', (data) => globalThis.onmessage({ data }));
