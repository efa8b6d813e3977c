// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The test appends this to a viewer page. It works every switch as a user does, looks at the pixels, and writes one line
// a check into an element of its own: "ok" or "failed" at the begin. The query of the address may
// name the only function to run.

const { panel, address_of, apply_address, svg_of, errors } = window.cscd;
const lines = [];
const element = (id) => document.getElementById(id);
const all = (selector) => [...document.querySelectorAll(selector)];

function check(is_right, text) {
  lines.push(`${is_right ? 'ok' : 'failed'} ${text}`);
}

function picture() {
  panel.view.draw();
  const gl = panel.view.renderer.getContext();
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return new Uint32Array(pixels.buffer);
}

function difference(a, b) {
  return a.reduce((count, pixel, i) => count + (pixel === b[i] ? 0 : 1), 0);
}

function check_change(name, change, undo) {
  const least = 50; // pixels
  const before = picture();
  change();
  const changed = difference(before, picture());
  check(changed >= least, `${name}: ${changed} pixels changed`);
  undo();
  const left = difference(before, picture());
  check(left === 0, `${name} undone: ${left} pixels differ`);
}

// Sets a slider or a list as a user does.
function pick(id, value) {
  element(id).value = value;
  element(id).dispatchEvent(new Event('input'));
}

function check_switches() {
  const empty = picture().fill(0);
  const drawn = difference(empty, picture()) / empty.length;
  check(drawn > 0.01, `drawn: ${(100 * drawn).toFixed(1)} % of the picture`);
  for (const box of all('[data-switch]')) {
    if (box.disabled) lines.push(`absent ${box.dataset.switch}`);
    else
      check_change(
        `switch ${box.dataset.switch}`,
        () => box.click(),
        () => box.click(),
      );
  }
  const boxes = all('[data-switch]').filter((box) => box.checked);
  boxes.forEach((box) => box.click());
  const left = difference(empty, picture());
  check(left === 0, `all switched off: ${left} pixels left`);
  boxes.forEach((box) => box.click());
  const opacity = element('opacity').value;
  check_change(
    'slider opacity',
    () => pick('opacity', 90),
    () => pick('opacity', opacity),
  );
}

function figures() {
  return all('#figures div')
    .map((cell) => `${cell.firstChild.textContent} ${cell.lastChild.textContent}`)
    .join(', ');
}

function check_detail() {
  if (element('significance').disabled) {
    lines.push('absent detail');
    return;
  }
  const whole = figures();
  for (const name of ['significance', 'length']) {
    for (const value of [1, 2, 4, 8]) {
      pick(name, value);
      lines.push(`${name} ${value}: ${figures()}`);
    }
    pick(name, 0);
  }
  const most = element('significance').max;
  pick('significance', most);
  const changes = figures() !== whole;
  pick('significance', 0);
  check(figures() === whole, `detail undone: ${whole}`);
  if (changes)
    check_change(
      'slider significance',
      () => pick('significance', most),
      () => pick('significance', 0),
    );
}

function check_movements() {
  const { view } = panel;
  const canvas = view.renderer.domElement;
  const mouse = (type, x, button) =>
    (type === 'mousedown' ? canvas : document).dispatchEvent(
      new MouseEvent(type, { clientX: x, clientY: 200, button, bubbles: true, cancelable: true }),
    );
  const drag = (button) => {
    mouse('mousedown', 300, button);
    mouse('mousemove', 380, button);
    mouse('mouseup', 380, button);
    view.settle();
  };
  const wheel = () => {
    canvas.dispatchEvent(new WheelEvent('wheel', { deltaY: -300, cancelable: true }));
    view.settle();
  };
  const reset = () => element('reset').click();
  check_change('turn', () => drag(0), reset);
  check_change('pan', () => drag(2), reset);
  check_change('zoom', wheel, reset);
  const up = view.up;
  const choose = (axis) => all(`[data-up=${axis}]`)[0].click();
  check_change(
    'up',
    () => choose(up === 'z' ? 'y' : 'z'),
    () => choose(up),
  );
  const press = (key) => window.dispatchEvent(new KeyboardEvent('keydown', { key }));
  check_change(
    'key s',
    () => press('s'),
    () => press('S'),
  );
  press('?');
  check(!element('help').hidden && /Drag: turn/.test(element('help').textContent), 'key ? shows the help');
  press('Escape');
  check(element('help').hidden, 'key Escape hides the help');
}

function check_lists() {
  panel.set_visible('color', true);
  for (const name of element('significance').disabled ? ['region'] : ['region', 'radius', 'significance'])
    check_change(
      `coloring ${name}`,
      () => pick('coloring', name),
      () => pick('coloring', 'branch'),
    );
  panel.set_visible('color', false);
  for (const axis of ['x', 'y', 'z'])
    check_change(
      `clip ${axis}`,
      () => {
        pick('clip_axis', axis);
        pick('clip', 50);
      },
      () => pick('clip', 100),
    );
  pick('background', 'dark');
  check(getComputedStyle(document.body).backgroundColor === 'rgb(16, 21, 29)', 'background dark');
  pick('background', 'light');
}

// A click on a node shows its row, and a click off the skeleton shows none.
function check_click() {
  const { view, model } = panel;
  const click = (x, y) => {
    for (const type of ['pointerdown', 'pointerup'])
      view.element.dispatchEvent(new PointerEvent(type, { clientX: x, clientY: y }));
  };
  const place = view.project(model.node_positions.subarray(0, 3));
  check_change(
    'click',
    () => click(place.x, place.y),
    () => {
      const text = element('row').textContent;
      check(/^node \d+, degree/.test(text), `row: ${text.replace(/\n/g, '; ')}`);
      click(view.width - 1, 1);
    },
  );
  check(element('row').hidden, 'row closed');
}

function check_files() {
  const canvas = panel.view.picture(300, '#ffffff');
  const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  check(canvas.width === 300 && pixels.some((value, i) => i % 4 < 3 && value < 128), 'png of 300 pixels');
  const svg = new DOMParser().parseFromString(svg_of(panel), 'image/svg+xml');
  const count = svg.getElementsByTagName('line').length;
  const shown = panel.detail.counts.edges;
  check(count === shown, `svg: ${count} lines of ${shown} edges`);
  const saved = [];
  const create = URL.createObjectURL;
  URL.createObjectURL = (blob) => {
    saved.push(blob.type);
    return create.call(URL, blob);
  };
  element('svg').click();
  URL.createObjectURL = create;
  check(saved.join() === 'image/svg+xml', `saved ${saved}`);
}

// The address of a moved view makes the same picture again.
function check_address() {
  const { view } = panel;
  view.camera.position.applyAxisAngle(view.camera.up, 0.7);
  view.settle();
  panel.set_visible('nodes', false);
  panel.set('coloring', 'region');
  const address = address_of(panel);
  const before = picture();
  const undo = () => {
    panel.set_visible('nodes', true);
    panel.set('coloring', 'branch');
    view.reset();
  };
  undo();
  apply_address(panel, address);
  const different = difference(before, picture()) / before.length;
  check(different < 0.002, `address: ${(100 * different).toFixed(2)} % of the picture differ`);
  undo();
}

function check_resize() {
  const { view } = panel;
  const width = view.element.clientWidth;
  Object.assign(view.element.style, { width: `${width / 2}px`, right: 'auto' });
  window.dispatchEvent(new Event('resize'));
  const ratio = view.renderer.domElement.clientWidth / width;
  check(Math.abs(ratio - 0.5) < 0.01, `resize: the canvas follows its element, ${ratio.toFixed(2)} of the width`);
  Object.assign(view.element.style, { width: '', right: '' });
  window.dispatchEvent(new Event('resize'));
}

function run() {
  check_switches();
  check_detail();
  check_movements();
  check_lists();
  check_click();
  check_files();
  check_address();
  check_resize();
  const code = panel.view.renderer.getContext().getError();
  check(code === 0, `WebGL error code ${code}`);
}

const only = { '?check_detail': check_detail, '?check_resize': check_resize }[location.search];
try {
  (only ?? run)();
} catch (error) {
  check(false, `error: ${error.stack}`);
}
for (const error of errors) check(false, `error: ${error}`);
const failures = lines.filter((line) => line.startsWith('failed')).length;
lines.push(failures === 0 ? 'selftest passed' : `selftest failed: ${failures}`);
const result = document.body.appendChild(document.createElement('pre'));
result.id = 'selftest';
result.textContent = lines.join('\n');
