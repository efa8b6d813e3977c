// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panel and the keyboard: they choose the content of the picture.

import { make_coloring, ramp, special_colors } from './colors.js';
import { branches_at, describe_branch, describe_node, detail_of, figure } from './model.js';
import { color_surface, make_highlight, make_skeleton_objects } from './scene.js';

const narrow = 560; // pixels, as in the style
const backgrounds = { light: '#f5f7fa', white: '#ffffff', dark: '#10151d' };
// The names in the address, the labels, and the keys of the switches; some are on at first.
const switches = [
  ['surface', 'Surface', 'S', true],
  ['skeleton', 'Skeleton', 'K', true],
  ['nodes', 'Nodes', 'N', true],
  ['balls', 'Balls (radius)', 'B', false],
  ['separators', 'Separators', 'P', false],
  ['color', 'Color the surface', 'C', false],
  ['points', 'Points', 'T', false],
  ['repairs', 'Repairs of the surface', 'E', false],
];

const choices = {
  coloring: ['branch', 'region', 'radius', 'significance'],
  clip_axis: ['x', 'y', 'z'],
  background: Object.keys(backgrounds),
};

// The sliders and lists.
export const inputs = ['opacity', 'significance', 'length', 'coloring', 'background', 'clip_axis', 'clip'];

const element = (id) => document.getElementById(id);

export class Panel {
  // `uniforms` are those of the surface; `objects` of the scene have the names of their switches.
  constructor(view, model, detail, coloring, objects, uniforms) {
    Object.assign(this, { view, model, detail, coloring, objects, uniforms, visible: {}, highlight: null });
    this.element = element('panel');
    const heading = this.element.querySelector('h1');
    heading.textContent = document.title;
    heading.addEventListener('click', () => this.element.classList.toggle('folded'));
    this.element.classList.toggle('folded', window.innerWidth <= narrow);
    this.show_figures();
    for (const [name, label, key, is_on] of switches) this.add_switch(name, label, key, is_on);
    for (const id of ['significance', 'length']) {
      element(id).disabled = !model.node_radii;
      element(id).closest('.row').hidden = !model.node_radii;
    }
    for (const [id, names] of Object.entries(choices)) element(id).append(...names.map((name) => new Option(name)));
    for (const id of inputs) element(id).addEventListener('input', () => this.set(id, element(id).value));
    this.set_opacity();
    this.set_clip();
    for (const button of this.element.querySelectorAll('[data-up]'))
      button.addEventListener('click', () => this.choose_up(button.dataset.up));
    element('reset').addEventListener('click', () => view.reset());
    element('help_button').addEventListener('click', () => this.toggle_help());
    element('help').addEventListener('click', () => this.toggle_help());
    window.addEventListener('keydown', (event) => this.press(event));
    window.addEventListener('resize', () => this.make_room());
    this.make_room();
    this.mark_up();
  }

  background() {
    return backgrounds[element('background').value];
  }

  show_figures() {
    const cells = Object.entries(this.detail.counts).map(([name, count]) => {
      const cell = document.createElement('div');
      cell.appendChild(document.createElement('b')).textContent = count.toLocaleString('en');
      const color = { tips: special_colors.tip, junctions: special_colors.junction }[name];
      if (color) cell.appendChild(document.createElement('i')).outerHTML = `<i style="color: ${color}">●</i> `;
      cell.append(name);
      return cell;
    });
    element('figures').replaceChildren(...cells);
  }

  add_switch(name, label, key, is_on) {
    const item = element('switches').appendChild(document.createElement('label'));
    item.className = 'row switch';
    item.innerHTML = `<input type="checkbox" data-switch="${name}" />${label}<kbd>${key}</kbd>`;
    const box = item.firstElementChild;
    box.disabled = item.hidden = name !== 'color' && !this.objects[name];
    box.addEventListener('change', () => this.set_visible(name, box.checked));
    this.set_visible(name, is_on);
  }

  set_visible(name, is_on) {
    const box = this.element.querySelector(`[data-switch="${name}"]`);
    if (!box || box.disabled) return;
    box.checked = this.visible[name] = is_on;
    if (name === 'color') this.uniforms.colored.value = is_on ? 1 : 0;
    else this.objects[name].visible = is_on;
    this.view.is_stale = true;
  }

  // Changes a slider or a list as a user does; a value that it does not offer is ignored.
  set(id, value) {
    const input = element(id);
    if (input.disabled || (input.options && ![...input.options].some((option) => option.value === value))) return;
    input.value = value;
    if (input.type === 'range') input.nextElementSibling.textContent = input.value;
    if (id === 'opacity') this.set_opacity();
    else if (id === 'clip' || id === 'clip_axis') this.set_clip();
    else if (id === 'coloring') this.set_coloring();
    else if (id === 'background') this.set_background();
    else this.set_detail();
    this.view.is_stale = true;
  }

  set_opacity() {
    const percent = Number(element('opacity').value);
    element('opacity').nextElementSibling.textContent = `${percent} %`;
    this.uniforms.opacity.value = percent / 100;
  }

  // Hides the surface beyond this percentage of the box along the axis.
  set_clip() {
    const percent = Number(element('clip').value);
    const axis = element('clip_axis').value;
    element('clip').nextElementSibling.textContent = percent < 100 ? `${percent} %` : 'off';
    const { min, max } = this.view.box;
    const beyond = percent < 100 ? min[axis] + (percent / 100) * (max[axis] - min[axis]) : 1e9;
    this.uniforms.clip.value.set(+(axis === 'x'), +(axis === 'y'), +(axis === 'z'), beyond);
  }

  set_coloring() {
    this.coloring = make_coloring(this.model, element('coloring').value);
    color_surface(this.objects.surface, this.model, this.coloring);
    this.remake_skeleton();
    const legend = element('legend');
    legend.hidden = !this.coloring.range;
    if (legend.hidden) return;
    this.coloring.range.forEach((value, i) => (legend.children[i].textContent = figure(value)));
    legend.style.background = `linear-gradient(90deg, ${[0, 0.25, 0.5, 0.75, 1].map(ramp).join(', ')})`;
  }

  set_background() {
    document.body.dataset.background = element('background').value;
    special_colors.junction = element('background').value === 'dark' ? '#f1f5f9' : '#111827';
    this.remake_skeleton();
    this.show_figures();
  }

  // Draws the skeleton without the branches that measure less than the sliders demand.
  set_detail() {
    const [significance, length] = ['significance', 'length'].map((id) => Number(element(id).value));
    this.detail = detail_of(this.model, { significance, length });
    this.choose(null);
    this.remake_skeleton();
    this.show_figures();
  }

  remake_skeleton() {
    for (const [name, object] of Object.entries(make_skeleton_objects(this.model, this.detail, this.coloring))) {
      object.visible = this.objects[name].visible;
      this.remove(this.objects[name]);
      this.view.scene.add(object);
      this.objects[name] = object;
    }
  }

  remove(object) {
    this.view.scene.remove(object);
    object.traverse(({ geometry, material }) => {
      if (!geometry) return;
      geometry.dispose();
      material.dispose();
    });
  }

  // Shows the measures of a node and of the branches there, and marks these; nothing for null.
  choose(node) {
    if (this.highlight) this.remove(this.highlight);
    this.highlight = null;
    this.view.is_stale = true;
    element('row').hidden = node === null;
    if (node === null) return;
    const { model, detail } = this;
    const branches = branches_at(model, detail, node);
    const lines = [describe_node(model, detail, node), ...branches.map((branch) => describe_branch(model, branch))];
    element('row').textContent = lines.join('\n');
    const edges = [...model.branch_of_edge.keys()].filter((edge) => branches.includes(model.branch_of_edge[edge]));
    this.highlight = make_highlight(model, edges);
    this.view.scene.add(this.highlight);
  }

  choose_up(axis) {
    this.view.look_from(axis);
    this.view.reset();
    this.mark_up();
  }

  mark_up() {
    for (const button of this.element.querySelectorAll('[data-up]'))
      button.classList.toggle('chosen', button.dataset.up === this.view.up);
  }

  show_panel(is_on) {
    this.element.hidden = !is_on;
    this.make_room();
  }

  toggle_help() {
    element('help').hidden = !element('help').hidden;
  }

  make_room() {
    const { right } = this.element.getBoundingClientRect();
    this.view.margin_left = right < 0.4 * window.innerWidth ? right : 0;
    this.view.resize();
  }

  press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.type === 'number') return;
    const key = event.key.toLowerCase();
    const [name] = switches.find((item) => item[2].toLowerCase() === key) || [];
    if (name) this.set_visible(name, !this.visible[name]);
    else if (key === 'r') this.view.reset();
    else if (key === 'h') this.show_panel(this.element.hidden);
    else if (key === '?' || (key === 'escape' && !element('help').hidden)) this.toggle_help();
  }
}
