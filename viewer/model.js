// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data of the page, and the results that need no picture. Points and node positions lie in a cube from -1 to 1;
// `frame` holds its center and half its extent in the input. The lengths and radii of branches are those of the input.

import { bytes_of_base64 } from './bytes.js';

export const NONE = 0xffffffff; // in arrays of indices

const array_types = { f: Float32Array, u: Uint32Array, d: Float64Array };

export function read_model(text) {
  const { arrays, ...model } = JSON.parse(text);
  for (const [name, [type, base64]] of Object.entries(arrays))
    model[name] = new array_types[type](bytes_of_base64(base64).buffer);
  model.number_of_nodes = model.node_positions.length / 3;
  model.number_of_edges = model.edges.length / 2;
  if (model.node_radii) model.node_radii = Float32Array.from(model.node_radii, (radius) => radius / model.frame[3]);
  return model;
}

export function ends_of_edge(model, edge) {
  return [model.edges[2 * edge], model.edges[2 * edge + 1]];
}

export function position_of_node(model, node) {
  return model.node_positions.subarray(3 * node, 3 * node + 3);
}

// Hides the branches whose significance or length over radius is below `least`. The page carries the value of each
// branch at which the library prunes it.
export function detail_of(model, least) {
  const is_shown = (branch) =>
    !model.node_radii ||
    (model.significance_limits[branch] >= least.significance && model.length_limits[branch] >= least.length);
  const is_edge_shown = Array.from(model.branch_of_edge, is_shown);
  const degree = new Uint32Array(model.number_of_nodes);
  const is_node_shown = Array(model.number_of_nodes).fill(true);
  for (const shown of [false, true]) {
    is_edge_shown.forEach((is_edge, edge) => {
      if (is_edge !== shown) return;
      for (const node of ends_of_edge(model, edge)) {
        is_node_shown[node] = shown;
        degree[node] += shown ? 1 : 0;
      }
    });
  }
  return { is_edge_shown, is_node_shown, degree, counts: count(model, is_edge_shown, is_node_shown, degree) };
}

// A branch ends at nodes of degree other than two. An isolated node is a branch, and so is a cycle without such nodes.
function count(model, is_edge_shown, is_node_shown, degree) {
  const parent = Array.from(degree, (_, node) => node);
  const root = (node) => {
    while (parent[node] !== node) node = parent[node] = parent[parent[node]];
    return node;
  };
  const counts = { nodes: 0, edges: 0, branches: 0, tips: 0, junctions: 0, cycles: 0 };
  is_edge_shown.forEach((is_shown, edge) => {
    if (!is_shown) return;
    const [a, b] = ends_of_edge(model, edge).map(root);
    ++counts.edges;
    counts.cycles += a === b ? 1 : 0;
    parent[a] = b;
  });
  const ends = new Float64Array(degree.length); // of the branches of each component
  degree.forEach((number, node) => {
    if (!is_node_shown[node]) return;
    ++counts.nodes;
    counts.tips += number === 1 ? 1 : 0;
    counts.junctions += number > 2 ? 1 : 0;
    ends[root(node)] += number === 2 ? 0 : number;
  });
  ends.forEach((number, node) => {
    if (is_node_shown[node] && parent[node] === node) counts.branches += Math.max(number / 2, 1);
  });
  return counts;
}

export function branches_at(model, { is_edge_shown }, node) {
  const branches = new Set();
  is_edge_shown.forEach((is_shown, edge) => {
    if (is_shown && ends_of_edge(model, edge).includes(node)) branches.add(model.branch_of_edge[edge]);
  });
  return [...branches];
}

// Five digits, as few as show the value.
export function figure(value) {
  return Number(value.toPrecision(5)).toString();
}

export function describe_node(model, { degree }, node) {
  const [x, y, z, scale] = model.frame;
  const place = Array.from(position_of_node(model, node), (value, k) => figure([x, y, z][k] + scale * value));
  const radius = model.node_radii ? `\nradius ${figure(scale * model.node_radii[node])}` : '';
  return `node ${node}, degree ${degree[node]}\nat ${place.join('  ')}${radius}`;
}

export function describe_branch(model, branch) {
  const edges = model.branch_of_edge.reduce((sum, other) => sum + (other === branch ? 1 : 0), 0);
  const parts = [`branch ${branch}: ${edges} edges`, `length ${figure(model.branch_lengths[branch])}`];
  if (model.node_radii) {
    parts.push(`radius ${figure(model.branch_radii[branch])}`);
    const significance = model.branch_significances[branch];
    if (Number.isFinite(significance)) parts.push(`significance ${figure(significance)}`);
  }
  return parts.join(', ');
}
