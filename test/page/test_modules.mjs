// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modules of the viewer page that do not need a browser. Run by `node --test`.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { make_coloring, ramp, special_colors } from '../../viewer/colors.js';
import * as data from '../../viewer/model.js';
import { smooth_unless_sharp } from '../../viewer/normals.js';

const encode = (type, numbers) => [type, Buffer.from(numbers.buffer).toString('base64')];

// A cycle of nodes 0, 1, 2, a branch 2 - 3 - 4 with twigs 4 - 5 and 4 - 6, and the isolated node 7.
function model_of(overrides = {}) {
  const arrays = {
    frame: encode('d', Float64Array.of(10, 20, 30, 2)),
    node_positions: encode(
      'f',
      Float32Array.from({ length: 24 }, (_, i) => (i % 3 === 0 ? i / 24 : 0)),
    ),
    node_radii: encode(
      'd',
      Float64Array.from({ length: 8 }, (_, i) => (i + 1) / 5),
    ),
    edges: encode('u', Uint32Array.of(0, 1, 1, 2, 2, 0, 2, 3, 3, 4, 4, 5, 4, 6)),
    branch_of_edge: encode('u', Uint32Array.of(0, 0, 0, 1, 1, 2, 3)),
    branch_of_node: encode('u', Uint32Array.of(0, 0, data.NONE, 1, data.NONE, 2, 3, 4)),
    branch_lengths: encode('d', Float64Array.of(3, 2, 1, 1.5, 0)),
    branch_radii: encode('d', Float64Array.of(0.2, 0.4, 0.5, 0.6, 0.8)),
    branch_significances: encode('d', Float64Array.of(Infinity, 4, 1, 4, Infinity)),
    significance_limits: encode('d', Float64Array.of(Infinity, 4, 1, 4, Infinity)),
    length_limits: encode('d', Float64Array.of(Infinity, 3, 3, 2, Infinity)),
    ...overrides,
  };
  return data.read_model(JSON.stringify({ number_of_points: 0, arrays }));
}

const counts_of = (model, significance, length) => data.detail_of(model, { significance, length }).counts;

test('read_model decodes arrays of every type', () => {
  const model = model_of();
  assert.deepEqual([...model.frame], [10, 20, 30, 2]);
  assert.equal(model.number_of_nodes, 8);
  assert.equal(model.number_of_edges, 7);
  assert.equal(model.node_positions[3], Math.fround(3 / 24));
  assert.equal(model.node_radii[2], Math.fround(0.3));
  assert.equal(model.branch_of_node[2], data.NONE);
  assert.equal(model.significance_limits[0], Infinity);
});

test('detail_of hides branches below either limit, and keeps cycles and isolated nodes', () => {
  const model = model_of();
  const whole = { nodes: 8, edges: 7, branches: 5, tips: 2, junctions: 2, cycles: 1 };
  const without_twig = { nodes: 7, edges: 6, branches: 3, tips: 1, junctions: 1, cycles: 1 };
  const cycle_alone = { nodes: 4, edges: 3, branches: 2, tips: 0, junctions: 0, cycles: 1 };
  assert.deepEqual(counts_of(model, 0, 0), whole);
  assert.deepEqual(counts_of(model, 1, 2), whole);
  assert.deepEqual(counts_of(model, 1.1, 0), without_twig);
  assert.deepEqual(counts_of(model, 0, 2.1), without_twig);
  assert.deepEqual(counts_of(model, 5, 0), cycle_alone);
  assert.deepEqual(counts_of(model, 1.1, 3.1), cycle_alone);
  const { degree, is_node_shown } = data.detail_of(model, { significance: 1.1, length: 0 });
  assert.deepEqual([...degree], [2, 2, 3, 2, 2, 0, 1, 0]);
  assert.deepEqual(is_node_shown, [true, true, true, true, true, false, true, true]);
});

test('detail_of hides nothing without radii', () => {
  const model = model_of();
  delete model.node_radii;
  assert.equal(counts_of(model, 9, 9).edges, 7);
});

test('descriptions are in the unit of the input', () => {
  const model = model_of();
  const detail = data.detail_of(model, { significance: 0, length: 0 });
  assert.equal(data.describe_node(model, detail, 4), 'node 4, degree 3\nat 11  20  30\nradius 1');
  assert.equal(data.describe_branch(model, 1), 'branch 1: 2 edges, length 2, radius 0.4, significance 4');
  assert.equal(data.describe_branch(model, 0), 'branch 0: 3 edges, length 3, radius 0.2');
  assert.deepEqual(data.branches_at(model, detail, 4), [1, 2, 3]);
  assert.deepEqual(data.branches_at(model, data.detail_of(model, { significance: 2, length: 0 }), 4), [1, 3]);
  assert.equal(data.figure(0.000123456789), '0.00012346');
});

test('branches that meet get different colors', () => {
  const { nodes, edges } = make_coloring(model_of(), 'branch');
  assert.equal(new Set([edges[0], edges[3], edges[5], edges[6]]).size, 4);
  assert.deepEqual([edges[0], edges[3]], [edges[2], edges[4]]);
  assert.deepEqual([nodes[0], nodes[2], nodes[3]], [edges[0], special_colors.shared, edges[3]]);
});

test('branches that meet differ even where colors are used again', () => {
  const number = 17; // one more than there are colors: a ring of branches, each an edge
  const counting = Uint32Array.from({ length: number }, (_, i) => i);
  const model = model_of({
    node_positions: encode('f', new Float32Array(3 * number)),
    edges: encode(
      'u',
      Uint32Array.from({ length: 2 * number }, (_, i) => ((i + 1) >> 1) % number),
    ),
    branch_of_edge: encode('u', counting),
    branch_of_node: encode('u', new Uint32Array(number).fill(data.NONE)),
    branch_lengths: encode('d', Float64Array.from(counting)),
  });
  const { edges } = make_coloring(model, 'branch');
  assert.equal(new Set(edges).size, number - 1);
  edges.forEach((color, i) => assert.notEqual(color, edges[(i + 1) % number]));
});

test('colorings by values have the range of the nodes', () => {
  const radius = make_coloring(model_of(), 'radius');
  assert.deepEqual(radius.range.map(data.figure), ['0.2', '1.6']);
  assert.deepEqual([radius.nodes[0], radius.nodes[7]], [ramp(0), ramp(1)]);
  const branch_significances = encode('d', Float64Array.of(Infinity, 4, 1, 2, Infinity));
  const significance = make_coloring(model_of({ branch_significances }), 'significance');
  assert.deepEqual(significance.range, [0, 4]);
  assert.deepEqual([significance.edges[5], significance.edges[0]], [ramp(0.25), ramp(1)]);
  assert.deepEqual([significance.nodes[4], significance.nodes[6]], [ramp(1), ramp(0.5)]);
  const region = make_coloring(model_of(), 'region');
  assert.equal(new Set(region.nodes).size, 8);
  assert.equal(region.range, undefined);
});

test('ramp interpolates between its ends', () => {
  assert.equal(ramp(0), 'rgb(68, 1, 84)');
  assert.equal(ramp(1), 'rgb(253, 231, 37)');
  assert.equal(ramp(7), ramp(1));
  assert.equal(ramp(0.125), 'rgb(64, 42, 112)');
});

test('normals are smooth on flat surfaces and sharp at creases', () => {
  const square = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
  const flat = smooth_unless_sharp(Float32Array.of(...square), Uint32Array.of(0, 1, 2, 0, 2, 3));
  assert.deepEqual([...flat.index], [0, 1, 2, 0, 2, 3]);
  assert.deepEqual([...flat.normals], Array(4).fill([0, 0, 1]).flat());

  // Two triangles at a right angle along the edge from 0 to 1.
  const edge = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  const bent = smooth_unless_sharp(edge, Uint32Array.of(0, 1, 2, 1, 0, 3));
  assert.deepEqual(bent.source, [0, 1, 2, 3, 0, 0, 1, 1]);
  const normal = (corner) => [...bent.normals.subarray(3 * bent.index[corner], 3 * bent.index[corner] + 3)];
  for (const corner of [0, 1, 2]) assert.deepEqual(normal(corner), [0, 0, 1]);
  for (const corner of [3, 4, 5]) assert.deepEqual(normal(corner), [0, 1, 0]);
});
