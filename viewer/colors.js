// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colors, as texts of CSS.

import { NONE, ends_of_edge } from './model.js';

export const special_colors = { tip: '#f59e0b', junction: '#111827', chosen: '#2563eb', shared: '#c3cad4' };

const palette = (
  '#2563eb #e11d48 #059669 #d97706 #7c3aed #0891b2 #db2777 #4d9411 ' +
  '#ea580c #4338ca #0d9488 #a21caf #b45309 #0284c7 #be123c #15803d'
).split(' ');

// From dark to light, so that the order shows in print, too.
const stops = ['#440154', '#3b528b', '#21918c', '#5ec962', '#fde725'].map((text) =>
  [1, 3, 5].map((begin) => parseInt(text.slice(begin, begin + 2), 16)),
);

// The color at this part, from 0 to 1, of the way along the stops.
export function ramp(part) {
  const place = Math.min(Math.max(part, 0), 1) * (stops.length - 1);
  const first = Math.min(Math.floor(place), stops.length - 2);
  const mix = stops[first].map((value, k) => Math.round(value + (place - first) * (stops[first + 1][k] - value)));
  return `rgb(${mix.join(', ')})`;
}

// The colors of nodes and edges by the quantity of this name, and the range for a legend.
export function make_coloring(model, name) {
  if (name === 'region') {
    const golden = 0.381966; // of a turn: the hues of consecutive nodes are far apart
    return {
      nodes: Array.from(
        { length: model.number_of_nodes },
        (_, node) => `hsl(${((node * golden) % 1) * 360}, 62%, 46%)`,
      ),
      edges: Array(model.number_of_edges).fill(special_colors.shared),
    };
  }
  if (name === 'branch' || !model.node_radii) {
    const colors = colors_of_branches(model);
    return {
      nodes: Array.from(model.branch_of_node, (branch) => colors[branch] || special_colors.shared),
      edges: Array.from(model.branch_of_edge, (branch) => colors[branch]),
    };
  }
  return color_by_values(name === 'radius' ? radii(model) : significances(model));
}

function radii(model) {
  const mean = (_, edge) => ends_of_edge(model, edge).reduce((sum, node) => sum + model.node_radii[node] / 2, 0);
  return { nodes: Array.from(model.node_radii), edges: Array.from(model.branch_of_edge, mean), unit: model.frame[3] };
}

// A node has the greatest significance of its edges.
function significances(model) {
  const nodes = Array(model.number_of_nodes).fill(0);
  const edges = Array.from(model.branch_of_edge, (branch) => model.branch_significances[branch]);
  edges.forEach((value, edge) => {
    for (const node of ends_of_edge(model, edge)) nodes[node] = Math.max(nodes[node], value);
  });
  return { nodes, edges, unit: 1 };
}

function color_by_values({ nodes, edges, unit }) {
  const finite = nodes.filter(Number.isFinite);
  const [least, most] = finite.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, 0]);
  const color = (value) => ramp(most > least ? (value - least) / (most - least) : 0);
  const range = finite.length > 0 ? [unit * least, unit * most] : [0, 0];
  return { nodes: nodes.map(color), edges: edges.map(color), range };
}

// Branches that meet get different colors. Of the colors allowed, the one used least so far is taken.
function colors_of_branches(model) {
  const meeting = new Map(); // the branches at each node that several share
  model.branch_of_edge.forEach((branch, edge) => {
    for (const node of ends_of_edge(model, edge)) {
      if (model.branch_of_node[node] !== NONE) continue;
      if (!meeting.has(node)) meeting.set(node, new Set());
      meeting.get(node).add(branch);
    }
  });
  const neighbors = Array.from(model.branch_lengths, () => new Set());
  for (const branches of meeting.values()) for (const a of branches) for (const b of branches) neighbors[a].add(b);
  const colors = [];
  const uses = new Map(palette.map((color) => [color, 0]));
  neighbors.forEach((others, branch) => {
    const taken = new Set([...others].map((other) => colors[other]));
    const free = palette.filter((color) => !taken.has(color));
    const choices = free.length > 0 ? free : [palette[branch % palette.length]];
    const best = choices.reduce((a, b) => (uses.get(b) < uses.get(a) ? b : a));
    uses.set(best, uses.get(best) + 1);
    colors.push(best);
  });
  return colors;
}
