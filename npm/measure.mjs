// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Usage: node measure.mjs PROGRAM MESH.off...
// The time of the package compared with that of the program with one thread, in turns. Run it where cscd is installed.

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { skeletonize } from 'cscd';

const rounds = 7;
const [program, ...meshes] = process.argv.slice(2);
const sum = (seconds) => Object.values(seconds).reduce((a, b) => a + b, 0);
const text = (seconds) => seconds.toFixed(2).padStart(8);

console.log('mesh, vertices: seconds of the first call, a later one, the program, ratio; the same of the stages alone');
for (const mesh of meshes) {
  const numbers = readFileSync(mesh, 'utf8').replace(/^OFF/, '').trim().split(/\s+/).map(Number);
  const end = 3 + 3 * numbers[0];
  const positions = Float64Array.from(numbers.slice(3, end));
  const indices = Uint32Array.from(numbers.slice(end).filter((_, i) => i % 4 !== 0));
  const calls = [];
  const stages = [];
  const runs = [];
  const native_stages = [];
  for (let round = 0; round < rounds; ++round) {
    const begin = performance.now();
    const { report } = await skeletonize(positions, indices);
    calls.push((performance.now() - begin) / 1000);
    stages.push(sum(report.seconds));
    const options = [mesh, '--threads', '1', '--quiet', '--report', '-'];
    const start = performance.now();
    const native = JSON.parse(execFileSync(program, options, { maxBuffer: 1 << 30 }));
    runs.push((performance.now() - start) / 1000);
    native_stages.push(sum(native.seconds));
  }
  const [call, run, stage, native] = [calls.slice(1), runs, stages, native_stages].map((all) => Math.min(...all));
  const row = [calls[0], call, run, call / run, stage, native, stage / native].map(text).join('');
  console.log(`${basename(mesh)}, ${numbers[0]}:${row}`);
}
