// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the installed package: run by build.sh in a fresh folder. ELEPHANT is that of CGAL's data.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { skeletonize } from 'cscd';

// A torus of radii 3 and 1 around the z axis.
function torus(around = 60, across = 24) {
  const positions = [];
  const indices = [];
  const corner = (i, j) => (i % around) * across + (j % across);
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const [u, v] = [(2 * Math.PI * i) / around, (2 * Math.PI * j) / across];
      positions.push((3 + Math.cos(v)) * Math.cos(u), (3 + Math.cos(v)) * Math.sin(u), Math.sin(v));
      const [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
      indices.push(a, b, c, a, c, d);
    }
  }
  return [positions, indices];
}

function elephant() {
  const numbers = readFileSync(process.env.ELEPHANT, 'utf8').replace(/^OFF/, '').trim().split(/\s+/).map(Number);
  const end = 3 + 3 * numbers[0];
  const indices = numbers.slice(end).filter((_, i) => i % 4 !== 0);
  return [Float64Array.from(numbers.slice(3, end)), Uint32Array.from(indices)];
}

function degrees({ nodes, edges }) {
  const result = new Array(nodes.length / 3).fill(0);
  edges.forEach((node) => ++result[node]);
  return result;
}

test('a torus has one cycle, of its own radii', async () => {
  const [positions, indices] = torus();
  const skeleton = await skeletonize(positions, indices);
  assert.equal(skeleton.report.betti_number, 1);
  assert.ok(degrees(skeleton).every((degree) => degree === 2));
  skeleton.radii.forEach((radius) => assert.ok(Math.abs(radius - 1) < 0.05, `radius ${radius}`));
  assert.equal(skeleton.vertexToNode.length, positions.length / 3);
  assert.ok(skeleton.vertexToNode.every((node) => node >= 0 && node < skeleton.radii.length));
  // The node of a vertex is on its side of the torus.
  skeleton.vertexToNode.forEach((node, vertex) => {
    const [x, y] = skeleton.nodes.slice(3 * node);
    assert.ok(x * positions[3 * vertex] + y * positions[3 * vertex + 1] > 0);
  });
});

test('doubles are kept, and arrays of any type are taken', async () => {
  const [positions, indices] = torus();
  const far = Float64Array.from(positions, (x) => x + 1e6); // floats would be off by 0.03
  const { nodes } = await skeletonize(far, Uint32Array.from(indices));
  for (let i = 0; i < nodes.length; i += 3) {
    assert.ok(Math.abs(Math.hypot(nodes[i] - 1e6, nodes[i + 1] - 1e6) - 3) < 0.01);
    assert.ok(Math.abs(nodes[i + 2] - 1e6) < 0.01);
  }
  assert.equal(far.length, positions.length); // copied, not moved
  const single = await skeletonize(Float32Array.from(positions), indices);
  assert.equal(single.report.betti_number, 1);
});

test('an elephant has its tips, fewer at less detail', async () => {
  const skeleton = await skeletonize(...elephant());
  const tips = degrees(skeleton).filter((degree) => degree === 1).length;
  assert.equal(tips, skeleton.report.number_of_tips);
  assert.ok(tips >= 8 && tips <= 16, `${tips} tips`); // legs, trunk, tusks, ears, tail
  const plain = await skeletonize(...elephant(), { detail: 0 });
  assert.ok(plain.report.number_of_tips < tips);
  assert.equal(plain.report.options.detail, 0);
});

test('points are taken, too', async () => {
  const [positions] = torus(120, 48);
  const { report, vertexToNode } = await skeletonize(positions, null, { shape: 'surface' });
  assert.equal(report.domain, 'points');
  assert.equal(report.betti_number, 1);
  assert.equal(vertexToNode.length, 120 * 48);
});

test('wrong arguments are refused with the remedy', async () => {
  const [positions, indices] = torus();
  const refused = (pattern, ...args) => assert.rejects(skeletonize(...args), { message: pattern });
  await refused(/^details: is not an option; use one of detail, seed/, positions, indices, { details: 1 });
  await refused(/^detail: must be a number from 0 to 1, not 2$/, positions, indices, { detail: 2 });
  await refused(/^detail: must be a number, not "a"$/, positions, indices, { detail: 'a' });
  await refused(/^minComponent: must be an integer that is at least 1, not 0.5$/, positions, indices, {
    minComponent: 0.5,
  });
  await refused(/^borders: must be auto or bridge or open, not shut$/, positions, indices, { borders: 'shut' });
  await refused(/^shape tree: does not apply to meshes; leave it out$/, positions, indices, { shape: 'tree' });
  await refused(/^positions: must be an array/, positions.slice(1), indices);
  await refused(/^indices: number 0 is 9999; use vertices from 0 to 1439$/, positions, [9999, 1, 2]);
  await refused(/not finite|not a finite|nan/i, [NaN, ...positions.slice(1)], indices);
});

test('progress is told, and ends the work when it throws', async () => {
  const stages = new Set();
  await skeletonize(...elephant(), {
    onProgress(stage, fraction) {
      stages.add(stage);
      assert.ok(fraction >= 0 && fraction <= 1);
    },
  });
  assert.ok(stages.size >= 3, [...stages].join());
  const enough = new Error('enough');
  const onProgress = () => {
    throw enough;
  };
  await assert.rejects(skeletonize(...elephant(), { onProgress }), enough);
});

test('abort ends the work, before and while it is done', async () => {
  const control = new AbortController();
  const { signal } = control;
  const onProgress = () => control.abort();
  await assert.rejects(skeletonize(...elephant(), { signal, onProgress }), { name: 'AbortError' });
  await assert.rejects(skeletonize(...elephant(), { signal }), { name: 'AbortError' });
});

test('calls at the same time give the same skeleton', async () => {
  const [first, second] = await Promise.all([skeletonize(...torus()), skeletonize(...torus())]);
  assert.deepEqual(first.nodes, second.nodes);
});
