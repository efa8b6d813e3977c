// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Views to keep: the address, and pictures as files.

import { download } from './bytes.js';
import { ends_of_edge } from './model.js';
import { inputs } from './panel.js';
import { places_of_nodes } from './pointer.js';
import { color_of_node, tube_radius } from './scene.js';

// The part of the address behind # holds the choices of the panel and the camera. It can have switches (separators=1),
// opacity=60, significance=1, length=2 (over the radius), coloring=radius, background=dark, clip_axis=z, clip=60, up=z,
// turn=180 (degrees around up, from the first view), eye=x,y,z, target=x,y,z, panel=0.
export function address_of(panel) {
  const { view, model } = panel;
  const parameters = new URLSearchParams();
  for (const [name, is_on] of Object.entries(panel.visible)) parameters.set(name, is_on ? 1 : 0);
  for (const id of inputs) parameters.set(id, document.getElementById(id).value);
  parameters.set('up', view.up);
  for (const [name, point] of Object.entries(view.ends_of_sight())) {
    const place = point.toArray().map((value, k) => model.frame[k] + model.frame[3] * value);
    parameters.set(name, place.join());
  }
  return parameters.toString();
}

export function apply_address(panel, address) {
  const { view, model } = panel;
  for (const [name, value] of new URLSearchParams(address)) {
    const numbers = value.split(',').map(Number);
    if (inputs.includes(name)) panel.set(name, value);
    else if (name === 'up' && /^[xyz]$/.test(value)) panel.choose_up(value);
    else if (name === 'turn') {
      view.turn = numbers[0] || 0;
      view.reset();
    } else if (name === 'eye' || name === 'target') {
      if (numbers.length !== 3 || !numbers.every(Number.isFinite)) continue;
      view.ends_of_sight()[name].fromArray(numbers.map((number, k) => (number - model.frame[k]) / model.frame[3]));
      view.is_fitted = false;
      view.settle();
    } else if (name === 'panel') panel.show_panel(value !== '0');
    else panel.set_visible(name, value !== '0');
  }
}

// The shown skeleton, far parts first, in the pixels of the window.
export function svg_of(panel) {
  const { model, detail, view, coloring } = panel;
  const places = places_of_nodes(panel);
  const round = (value) => Number(value.toFixed(2));
  const width = round(2 * view.pixels(tube_radius(model)));
  const parts = []; // [depth, element]
  detail.is_edge_shown.forEach((is_shown, edge) => {
    const [a, b] = ends_of_edge(model, edge).map((node) => places[node]);
    if (!is_shown || !a || !b) return;
    const ends = `x1="${round(a.x)}" y1="${round(a.y)}" x2="${round(b.x)}" y2="${round(b.y)}"`;
    parts.push([(a.depth + b.depth) / 2, `<line ${ends} stroke="${coloring.edges[edge]}"/>`]);
  });
  places.forEach((place, node) => {
    if (!place || detail.degree[node] === 2) return;
    const color = color_of_node(node, detail.degree, coloring);
    parts.push([place.depth, `<circle cx="${round(place.x)}" cy="${round(place.y)}" r="${width}" fill="${color}"/>`]);
  });
  parts.sort((a, b) => b[0] - a[0]);
  const holder = document.createElement('div');
  holder.innerHTML =
    `<svg width="${view.width}" height="${view.height}" stroke-width="${width}" stroke-linecap="round">\n` +
    `${parts.map((part) => part[1]).join('\n')}\n</svg>`;
  return `${new XMLSerializer().serializeToString(holder.firstChild)}\n`; // with the name space
}

export function connect_savers(panel) {
  const name = document.title.replace(/[^\w.-]+/g, '_') || 'skeleton';
  document.getElementById('svg').addEventListener('click', () => {
    download(new Blob([svg_of(panel)], { type: 'image/svg+xml' }), `${name}.svg`);
  });
  document.getElementById('png').addEventListener('click', () => {
    const width = Math.max(16, Number(document.getElementById('width').value) || 1600);
    panel.view.picture(width, panel.background()).toBlob((blob) => download(blob, `${name}.png`));
  });
}
