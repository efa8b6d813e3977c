// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture: renderer, camera, controls.

/* global THREE */

const field_of_view = 26; // degrees
const tangent = Math.tan(((field_of_view / 2) * Math.PI) / 180);
const pixel_ratio = () => Math.min(window.devicePixelRatio || 1, 2);

// Most meshes have y up; one that is a long way along z stands upright.
function guess_up(size) {
  return size.z > 1.6 * Math.max(size.x, size.y) ? 'z' : 'y';
}

function box_of(points) {
  const box = new THREE.Box3().setFromArray(points);
  return box.isEmpty() ? box.expandByPoint(new THREE.Vector3()) : box;
}

// Looks along the narrower of the two level directions, somewhat from the side and from above.
function direction_of_view(up, size) {
  const level = ['x', 'y', 'z'].filter((axis) => axis !== up);
  const [narrow, wide] = size[level[0]] < 0.8 * size[level[1]] ? level : [level[1], level[0]];
  const direction = new THREE.Vector3();
  direction[narrow] = up === 'z' ? -1 : 1;
  direction[wide] = 0.42;
  direction[up] = 0.24;
  return direction.normalize();
}

export class View {
  constructor(element, model) {
    this.element = element;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(pixel_ratio());
    this.renderer.setClearColor(0xffffff, 0);
    element.appendChild(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(field_of_view, 1, 0.01, 100);
    this.points = model.positions.length > 0 ? model.positions : model.node_positions;
    this.box = box_of(this.points);
    this.unit = model.frame[3];
    this.turn = 0; // degrees around the up direction
    this.margin_left = 0; // pixels
    this.is_stale = true;
    // Scans have z up, and alone have no triangles.
    this.look_from(model.triangles.length === 0 ? 'z' : guess_up(this.size()));
    window.addEventListener('resize', () => this.resize());
    this.is_fitted = true;
    this.resize();
  }

  size() {
    return this.box.getSize(new THREE.Vector3());
  }

  // OrbitControls reads the up direction when it is made, hence a new one for each.
  look_from(up) {
    if (this.controls) this.controls.dispose();
    this.up = up;
    this.camera.up.set(+(up === 'x'), +(up === 'y'), +(up === 'z'));
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    Object.assign(this.controls, { enableDamping: true, dampingFactor: 0.12, rotateSpeed: 0.8 });
    Object.assign(this.controls, { screenSpacePanning: true, minDistance: 0.05, maxDistance: 30 });
    this.controls.addEventListener('change', () => (this.is_stale = true));
    this.controls.addEventListener('start', () => (this.is_fitted = false));
  }

  reset() {
    const direction = direction_of_view(this.up, this.size());
    direction.applyAxisAngle(this.camera.up, (this.turn * Math.PI) / 180);
    const target = this.box.getCenter(this.controls.target);
    this.camera.position.copy(target).add(direction);
    this.camera.lookAt(target);
    this.camera.position.copy(target).addScaledVector(direction, this.distance_to_fit());
    this.settle();
    this.is_fitted = true;
  }

  // The least distance where the picture holds all points, with a margin.
  distance_to_fit() {
    const margin = 1.12;
    const turn = this.camera.quaternion.clone().conjugate();
    const tangent_x = (tangent * (this.width - this.margin_left)) / this.height;
    const p = new THREE.Vector3();
    let distance = 0.1;
    for (let i = 0; i < this.points.length; i += 3) {
      p.fromArray(this.points, i).sub(this.controls.target).applyQuaternion(turn);
      distance = Math.max(distance, p.z + margin * Math.max(Math.abs(p.x) / tangent_x, Math.abs(p.y) / tangent));
    }
    return distance;
  }

  // Ends a movement that is dying down.
  settle() {
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = true;
    this.is_stale = true;
  }

  // Centers the shape right of the panel, and fits it there again unless the user has moved it.
  resize() {
    this.width = Math.max(1, this.element.clientWidth);
    this.height = Math.max(1, this.element.clientHeight);
    this.camera.aspect = this.width / this.height;
    this.camera.setViewOffset(this.width, this.height, -this.margin_left / 2, 0, this.width, this.height);
    this.renderer.setSize(this.width, this.height);
    this.is_stale = true;
    if (this.is_fitted) this.reset();
  }

  depth_of_target() {
    return this.camera.position.distanceTo(this.controls.target);
  }

  // The number of pixels of this length at the depth of the target.
  pixels(length) {
    return (length * this.height) / (2 * tangent * this.depth_of_target());
  }

  draw() {
    this.camera.near = Math.max(0.002, this.depth_of_target() / 50);
    this.camera.far = this.camera.near * 50 + 10;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
    this.is_stale = false;
    this.draw_scale();
  }

  // A bar of 1, 2 or 5 times a power of ten, in the unit of the input, at the depth of the target.
  draw_scale() {
    const bar = document.getElementById('scale');
    const longest = (140 / this.pixels(1)) * this.unit; // of 140 pixels
    const power = 10 ** Math.floor(Math.log10(longest));
    const length = [5, 2, 1].map((factor) => factor * power).find((candidate) => candidate <= longest);
    bar.style.width = `${this.pixels(length / this.unit)}px`;
    bar.textContent = Number(length.toPrecision(1));
  }

  // The picture in a canvas of this width in pixels; smaller where the browser cannot draw as many.
  picture(width, background) {
    this.renderer.setPixelRatio(width / this.width);
    this.draw();
    const drawn = this.renderer.domElement;
    const canvas = Object.assign(document.createElement('canvas'), { width: drawn.width, height: drawn.height });
    const context = canvas.getContext('2d');
    context.fillStyle = background;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(drawn, 0, 0);
    this.renderer.setPixelRatio(pixel_ratio());
    this.draw();
    return canvas;
  }

  // The place of a point in the window, in pixels, and its depth: nearer is less, in sight is below 1.
  project(point) {
    const p = new THREE.Vector3(...point).project(this.camera);
    return { x: ((p.x + 1) / 2) * this.width, y: ((1 - p.y) / 2) * this.height, depth: p.z };
  }

  run() {
    requestAnimationFrame(() => this.run());
    this.controls.update();
    if (this.is_stale) this.draw();
  }

  // The place of the camera and the point that it looks at, by their names in the address.
  ends_of_sight() {
    return { eye: this.camera.position, target: this.controls.target };
  }
}
