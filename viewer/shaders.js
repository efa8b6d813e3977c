// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shaders: surfaces, spheres, and tubes, each translucent or solid.

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
export const translucent_fragment = `${shading}
  uniform float opacity;
  varying float v_beyond;
  void main() {
    if (v_beyond > 0.) discard;
    vec3 n = normal_to_eye();
    float rim = pow(1. - clamp(dot(n, normalize(v_to_eye)), 0., 1.), 2.2);
    vec3 color = mix(lit(v_color, n), v_color * .52, .65 * rim * (1. - .6 * opacity));
    gl_FragColor = vec4(color, mix(opacity, 1., .62 * rim * smoothstep(0., .15, opacity)));
  }`;

export const solid_fragment = `${shading}
  uniform float paleness;
  void main() {
    vec3 n = normal_to_eye();
    float glint = pow(clamp(dot(n, normalize(vec3(-.3, .5, 1.))), 0., 1.), 40.);
    gl_FragColor = vec4(mix(lit(v_color, n) + .15 * glint, vec3(.93, .945, .965), paleness), 1.);
  }`;

export const surface_vertex = `
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

export const sphere_vertex = `
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

export const tube_vertex = `
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
