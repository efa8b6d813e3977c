// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the address behind # holds the choices of the panel and the camera. It can have switches (separators=1),
// opacity=60, significance=1, length=2 (over the radius), coloring=radius, background=dark, clip_axis=z, clip=60, up=z,
// turn=180 (degrees around up, from the first view), eye=x,y,z, target=x,y,z, panel=0.

const inputs = ['opacity', 'significance', 'length', 'coloring', 'background', 'clip_axis', 'clip'];

// All choices, as apply_address() reads them.
export function address_of(panel) {
  const parameters = new URLSearchParams();
  for (const [name, is_on] of Object.entries(panel.visible)) parameters.set(name, is_on ? 1 : 0);
  for (const id of inputs) parameters.set(id, document.getElementById(id).value);
  parameters.set('up', panel.view.up);
  for (const [name, point] of panel.view.camera_points()) parameters.set(name, point.join());
  return parameters.toString();
}

export function apply_address(panel, address) {
  for (const [name, value] of new URLSearchParams(address)) {
    const numbers = value.split(',').map(Number);
    if (inputs.includes(name)) panel.set(name, value);
    else if (name === 'up' && /^[xyz]$/.test(value)) panel.choose_up(value);
    else if (name === 'turn') {
      panel.view.turn = numbers[0] || 0;
      panel.view.reset();
    } else if (name === 'eye' || name === 'target') {
      if (numbers.length === 3 && numbers.every(Number.isFinite)) panel.view.set_camera_point(name, numbers);
    } else if (name === 'panel') panel.show_panel(value !== '0');
    else panel.set_visible(name, value !== '0');
  }
}
