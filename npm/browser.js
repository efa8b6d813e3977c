// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The package in browsers.

import { make_skeletonize } from './skeletonize.js';

export const skeletonize = make_skeletonize({
  async compile() {
    const response = await fetch(new URL('cscd.wasm', import.meta.url));
    if (!response.ok) throw new Error(`cscd.wasm: ${response.status}; serve it next to browser.js`);
    return WebAssembly.compile(await response.arrayBuffer());
  },
  start: () => new Worker(new URL('worker.js', import.meta.url), { type: 'module' }),
});
