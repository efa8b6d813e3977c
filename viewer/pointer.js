// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pointer: it reports the node below it, and a click chooses a node.

import { describe_node, ends_of_edge, position_of_node } from './model.js';

const reach = { mouse: 9, pen: 9, touch: 24 }; // pixels
const shake = 5; // pixels that a click may move

// The places in the window of the shown nodes in sight; null for the others.
export function places_of_nodes({ view, model, detail }) {
  return detail.is_node_shown.map((is_shown, node) => {
    const place = is_shown ? view.project(position_of_node(model, node)) : null;
    return place && place.depth < 1 ? place : null;
  });
}

// The number of the least distance below the reach, or null.
function nearest(distances, within) {
  const best = distances.reduce((least, distance, i) => (distance < distances[least] ? i : least), 0);
  return distances[best] < within ? best : null;
}

// The shown node nearest to a place of the window, within reach, or null.
function node_at(panel, x, y, within) {
  if (!panel.visible.nodes && !panel.visible.skeleton) return null;
  const distances = places_of_nodes(panel).map((place) => (place ? Math.hypot(place.x - x, place.y - y) : Infinity));
  return nearest(distances, within);
}

// The distance of a place from the segment between two others, and the part of the segment at the nearest point.
function distance_to_segment(x, y, a, b) {
  const [u, v] = [b.x - a.x, b.y - a.y];
  const part = Math.min(1, Math.max(0, ((x - a.x) * u + (y - a.y) * v) / (u * u + v * v || 1)));
  return { distance: Math.hypot(a.x + part * u - x, a.y + part * v - y), part };
}

// The node at a place; without a node, the nearer end of the edge there.
function node_or_end_at(panel, x, y, within) {
  const node = node_at(panel, x, y, within);
  if (node !== null || !panel.visible.skeleton) return node;
  const places = places_of_nodes(panel);
  const segments = panel.detail.is_edge_shown.map((is_shown, edge) => {
    const [a, b] = ends_of_edge(panel.model, edge).map((end) => places[end]);
    return is_shown && a && b ? distance_to_segment(x, y, a, b) : { distance: Infinity };
  });
  const distances = segments.map(({ distance }) => distance);
  const edge = nearest(distances, within);
  return edge === null ? null : ends_of_edge(panel.model, edge)[segments[edge].part < 0.5 ? 0 : 1];
}

export function connect_pointer(panel) {
  const tip = document.getElementById('tip');
  const canvas = panel.view.element;
  canvas.addEventListener('mousemove', ({ clientX, clientY, buttons }) => {
    const node = buttons === 0 ? node_at(panel, clientX, clientY, reach.mouse) : null;
    tip.hidden = node === null;
    if (node === null) return;
    tip.textContent = describe_node(panel.model, panel.detail, node);
    tip.style.left = `${clientX + 14}px`;
    tip.style.top = `${clientY + 14}px`;
  });
  let pressed = null;
  canvas.addEventListener('pointerdown', (event) => (pressed = event));
  canvas.addEventListener('pointerup', ({ clientX, clientY, pointerType }) => {
    if (pressed && Math.hypot(clientX - pressed.clientX, clientY - pressed.clientY) < shake)
      panel.choose(node_or_end_at(panel, clientX, clientY, reach[pointerType] || reach.mouse));
    pressed = null;
  });
}
