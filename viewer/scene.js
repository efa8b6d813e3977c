// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The objects of the scene and their shaders: surfaces, spheres, and tubes, each translucent or solid.

/* global THREE */
import { special_colors } from './colors.js';
import { ends_of_edge, position_of_node } from './model.js';
import { smooth_unless_sharp } from './normals.js';

const shading = `
  varying vec3 v_normal, v_to_eye, v_color;
  vec3 lit(vec3 color, vec3 n) {
    float key = .5 + .5 * dot(n, normalize(vec3(-.45, .75, .55)));
    float sky = .5 + .5 * n.y;
    return color * (.60 + .40 * key * key + .14 * sky);
  }
  vec3 normal_to_eye() {
    vec3 n = normalize(v_normal);
    return dot(n, v_to_eye) < 0. ? -n : n;
  }`;

// The rim is darker and more opaque, so that outlines show.
const translucent_fragment = `${shading}
  uniform float opacity;
  varying float v_beyond;
  void main() {
    if (v_beyond > 0.) discard;
    vec3 n = normal_to_eye();
    float rim = pow(1. - clamp(dot(n, normalize(v_to_eye)), 0., 1.), 2.2);
    vec3 color = mix(lit(v_color, n), v_color * .52, .65 * rim * (1. - .6 * opacity));
    gl_FragColor = vec4(color, mix(opacity, 1., .62 * rim * smoothstep(0., .15, opacity)));
  }`;

const solid_fragment = `${shading}
  uniform float paleness;
  void main() {
    vec3 n = normal_to_eye();
    float glint = pow(clamp(dot(n, normalize(vec3(-.3, .5, 1.))), 0., 1.), 40.);
    gl_FragColor = vec4(mix(lit(v_color, n) + .15 * glint, vec3(.93, .945, .965), paleness), 1.);
  }`;

const surface_vertex = `
  attribute vec3 branch_color;
  uniform float colored;
  uniform vec4 clip;
  varying vec3 v_normal, v_to_eye, v_color;
  varying float v_beyond;
  void main() {
    v_beyond = dot(position, clip.xyz) - clip.w;
    vec4 p = modelViewMatrix * vec4(position, 1.);
    v_normal = normalMatrix * normal;
    v_to_eye = -p.xyz;
    v_color = mix(vec3(.56, .64, .74), branch_color, colored);
    gl_Position = projectionMatrix * p;
  }`;

const sphere_vertex = `
  attribute vec3 center, color;
  attribute float radius;
  varying vec3 v_normal, v_to_eye, v_color;
  varying float v_beyond;
  void main() {
    v_beyond = 0.;
    vec4 p = modelViewMatrix * vec4(center + radius * position, 1.);
    v_normal = normalMatrix * position;
    v_to_eye = -p.xyz;
    v_color = color;
    gl_Position = projectionMatrix * p;
  }`;

const tube_vertex = `
  attribute vec3 start, end, color;
  uniform float radius;
  varying vec3 v_normal, v_to_eye, v_color;
  vec3 unit(vec3 v) { return v / max(length(v), 1e-12); }
  void main() {
    vec3 axis = end - start;
    vec3 helper = abs(axis.y) < .9 * length(axis) ? vec3(0., 1., 0.) : vec3(1., 0., 0.);
    vec3 u = unit(cross(axis, helper)), w = unit(cross(axis, u));
    vec3 outward = u * position.x + w * position.z;
    vec4 p = modelViewMatrix * vec4(mix(start, end, position.y + .5) + radius * outward, 1.);
    v_normal = normalMatrix * outward;
    v_to_eye = -p.xyz;
    v_color = color;
    gl_Position = projectionMatrix * p;
  }`;

// Objects with a smaller number are drawn first.
const render_order = { points: 5, balls: 10, surface: 20, near_curves: 30, marks: 40 };

const rgb = (text) => new THREE.Color(text).toArray();

function shaded(geometry, parameters) {
  const mesh = new THREE.Mesh(geometry, new THREE.ShaderMaterial({ side: THREE.DoubleSide, ...parameters }));
  mesh.frustumCulled = false;
  return mesh;
}

function solid(geometry, vertexShader, uniforms) {
  const all = { paleness: { value: 0 }, ...uniforms };
  return shaded(geometry, { vertexShader, fragmentShader: solid_fragment, uniforms: all });
}

// Only the layer nearest to the eye is blended: a first pass writes depth alone. Solid objects are drawn before, and so
// shine through. Triangles need no sorting, and bodies behind one another do not add up to a fog.
function translucent(geometry, vertexShader, uniforms, order) {
  const look = { vertexShader, fragmentShader: translucent_fragment, uniforms, transparent: true };
  const depth = shaded(geometry, { ...look, colorWrite: false });
  const color = shaded(geometry, { ...look, depthWrite: false });
  depth.renderOrder = order;
  color.renderOrder = order + 1;
  return group_of(depth, color);
}

function group_of(...objects) {
  return new THREE.Group().add(...objects);
}

// `attributes` has [values, size] by name.
function instanced(base, attributes) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.index = base.index;
  geometry.setAttribute('position', base.attributes.position);
  for (const [name, [values, size]] of Object.entries(attributes))
    geometry.setAttribute(name, new THREE.InstancedBufferAttribute(new Float32Array(values.flat()), size));
  return geometry;
}

// `tubes` are [start, end, color].
function tubes_geometry(tubes, sides) {
  const [start, end, color] = [0, 1, 2].map((part) => [tubes.flatMap((tube) => [...tube[part]]), 3]);
  return instanced(new THREE.CylinderBufferGeometry(1, 1, 1, sides, 1, true), { start, end, color });
}

// `spheres` are [center, radius, color].
function spheres_geometry(spheres, detail) {
  const [center, color] = [0, 2].map((part) => [spheres.flatMap((sphere) => [...sphere[part]]), 3]);
  const radius = [spheres.map((sphere) => sphere[1]), 1];
  return instanced(new THREE.SphereBufferGeometry(1, 2 * detail, detail), { center, radius, color });
}

export function make_surface(model, coloring, uniforms) {
  const { index, source, normals } = smooth_unless_sharp(model.positions, model.triangles);
  const positions = new Float32Array(3 * source.length);
  source.forEach((v, i) => positions.set(model.positions.subarray(3 * v, 3 * v + 3), 3 * i));
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  geometry.setAttribute('branch_color', new THREE.BufferAttribute(new Float32Array(3 * source.length), 3));
  const surface = translucent(geometry, surface_vertex, uniforms, render_order.surface);
  surface.userData = { geometry, source };
  color_surface(surface, model, coloring);
  return surface;
}

export function color_surface(surface, model, coloring) {
  const { geometry, source } = surface.userData;
  const colors = geometry.attributes.branch_color;
  const colors_of_nodes = coloring.nodes.map(rgb);
  const shared = rgb(special_colors.shared);
  source.forEach((v, i) => colors.array.set(colors_of_nodes[model.node_of_vertex[v]] || shared, 3 * i));
  colors.needsUpdate = true;
}

// Thin enough for thin limbs, thick enough to be seen. The scene is two units wide.
export function tube_radius(model) {
  const [thinnest, thickest] = [0.006, 0.0085];
  if (!model.node_radii) return thickest;
  const median = model.node_radii.slice().sort()[model.number_of_nodes >> 1] || 0;
  return Math.min(thickest, Math.max(thinnest, 0.12 * median));
}

function make_skeleton(model, detail, coloring, radius) {
  const tubes = [];
  const joints = [];
  detail.is_edge_shown.forEach((is_shown, edge) => {
    if (!is_shown) return;
    const ends = ends_of_edge(model, edge).map((node) => position_of_node(model, node));
    const color = rgb(coloring.edges[edge]);
    tubes.push([...ends, color]);
    for (const end of ends) joints.push([end, radius, color]);
  });
  return group_of(
    solid(tubes_geometry(tubes, 12), tube_vertex, { radius: { value: radius } }),
    solid(spheres_geometry(joints, 8), sphere_vertex),
  );
}

export function color_of_node(node, degree, coloring) {
  if (degree[node] > 2) return special_colors.junction;
  return degree[node] === 1 ? special_colors.tip : coloring.nodes[node];
}

function make_nodes(model, { is_node_shown, degree }, coloring, radius) {
  const spheres = [];
  is_node_shown.forEach((is_shown, node) => {
    if (!is_shown) return;
    const [size, brightness] = degree[node] === 2 ? [1.4, 0.8] : degree[node] === 1 ? [1.9, 1] : [2.2, 1];
    const color = rgb(color_of_node(node, degree, coloring)).map((value) => brightness * value);
    spheres.push([position_of_node(model, node), size * radius, color]);
  });
  return solid(spheres_geometry(spheres, 10), sphere_vertex);
}

function make_balls(model, { is_node_shown }, coloring) {
  const spheres = [];
  is_node_shown.forEach((is_shown, node) => {
    if (is_shown) spheres.push([position_of_node(model, node), model.node_radii[node], rgb(coloring.nodes[node])]);
  });
  return translucent(spheres_geometry(spheres, 16), sphere_vertex, { opacity: { value: 0.38 } }, render_order.balls);
}

function nearest_node(model, point) {
  let best = 0;
  let least = Infinity;
  for (let node = 0; node < model.number_of_nodes; ++node) {
    const distance = Math.hypot(...position_of_node(model, node).map((value, k) => value - point[k]));
    if (distance < least) [best, least] = [node, distance];
  }
  return best;
}

// Closed curves, each in the color of the node nearest to its middle. They are drawn pale, and again in full color
// once the depth of the surface is known: parts on the far side stay pale.
function make_separators(model, coloring, radius) {
  const tubes = [];
  const { separator_points: points, separator_offsets: offsets } = model;
  for (let s = 0; s + 1 < offsets.length; ++s) {
    const curve = [];
    for (let i = offsets[s]; i < offsets[s + 1]; ++i) curve.push(points.subarray(3 * i, 3 * i + 3));
    const middle = [0, 1, 2].map((k) => curve.reduce((sum, point) => sum + point[k] / curve.length, 0));
    const color = rgb(coloring.nodes[nearest_node(model, middle)] || special_colors.junction);
    curve.forEach((point, i) => tubes.push([point, curve[(i + 1) % curve.length], color]));
  }
  const geometry = tubes_geometry(tubes, 6);
  const far = solid(geometry, tube_vertex, { radius: { value: radius }, paleness: { value: 0.72 } });
  const near = solid(geometry, tube_vertex, { radius: { value: radius } });
  near.material.transparent = true; // drawn in the order of the translucent objects
  near.renderOrder = render_order.near_curves;
  return group_of(far, near);
}

// Thick tubes around these edges.
export function make_highlight(model, edges) {
  const color = rgb(special_colors.chosen);
  const tubes = edges.map((edge) => [...ends_of_edge(model, edge).map((node) => position_of_node(model, node)), color]);
  return solid(tubes_geometry(tubes, 12), tube_vertex, { radius: { value: 2 * tube_radius(model) } });
}

// Dots of a size in pixels.
function make_dots(positions, color, size, is_in_front) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  const look = { color, size, sizeAttenuation: false, depthTest: !is_in_front, transparent: true };
  const dots = new THREE.Points(geometry, new THREE.PointsMaterial(look));
  dots.frustumCulled = false;
  dots.renderOrder = is_in_front ? render_order.marks : render_order.points;
  return dots;
}

// The objects that depend on the detail and on the coloring, by the names of their switches.
export function make_skeleton_objects(model, detail, coloring) {
  const radius = tube_radius(model);
  const objects = {
    skeleton: make_skeleton(model, detail, coloring, radius),
    nodes: make_nodes(model, detail, coloring, radius),
  };
  if (model.node_radii) objects.balls = make_balls(model, detail, coloring);
  if (model.separator_offsets.length > 1) objects.separators = make_separators(model, coloring, 0.55 * radius);
  return objects;
}

export function make_objects(model, detail, coloring, uniforms) {
  const objects = make_skeleton_objects(model, detail, coloring);
  objects.surface = make_surface(model, coloring, uniforms);
  if (model.number_of_points > 0)
    objects.points = make_dots(model.positions.slice(0, 3 * model.number_of_points), 0x30405a, 2, false);
  if (model.cut_handles.length + model.joined_gaps.length > 0)
    objects.repairs = group_of(
      make_dots(model.cut_handles, 0xd01040, 11, true),
      make_dots(model.joined_gaps, 0xf08000, 9, true),
    );
  return objects;
}
