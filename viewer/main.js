// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Starts the page.

/* global THREE */
import { make_coloring } from './colors.js';
import { detail_of, read_model } from './model.js';
import { Panel } from './panel.js';
import { connect_pointer } from './pointer.js';
import { make_objects } from './scene.js';
import { address_of, apply_address, connect_savers, svg_of } from './share.js';
import { View } from './view.js';

function start() {
  if (typeof THREE === 'undefined' || !THREE.OrbitControls)
    throw new Error('This page was written without three.js and its OrbitControls.');
  const model = read_model(document.getElementById('cscd-data').textContent);
  const uniforms = { opacity: { value: 0 }, colored: { value: 0 }, clip: { value: new THREE.Vector4() } };
  const view = new View(document.getElementById('view'), model);
  const detail = detail_of(model, { significance: 0, length: 0 });
  const coloring = make_coloring(model, 'branch');
  const objects = make_objects(model, detail, coloring, uniforms);
  view.scene.add(...Object.values(objects));
  const panel = new Panel(view, model, detail, coloring, objects, uniforms);
  if (model.triangles.length === 0) panel.set_visible('points', true);
  connect_pointer(panel);
  connect_savers(panel);
  document.getElementById('link').addEventListener('click', () => (location.hash = address_of(panel)));
  apply_address(panel, location.hash.slice(1));
  view.draw();
  view.run();
  Object.assign(window.cscd, { panel, address_of, apply_address, svg_of });
}

try {
  start();
} catch (error) {
  const message = document.getElementById('message');
  message.hidden = false;
  message.textContent = `The picture cannot be shown. ${error.message}`;
  window.cscd.errors.push(error.message);
}
window.cscd.is_ready = true;
