// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Smooth normals that leave sharp edges sharp.

const crease_angle = Math.PI / 4;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const norm = (v) => Math.sqrt(dot(v, v));

// One normal for each triangle, as long as twice its area.
function normals_of_faces(positions, triangles) {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    for (let k = 0; k < 3; ++k) {
      const y = (k + 1) % 3;
      const z = (k + 2) % 3;
      normals[t + k] =
        (positions[b + y] - positions[a + y]) * (positions[c + z] - positions[a + z]) -
        (positions[b + z] - positions[a + z]) * (positions[c + y] - positions[a + y]);
    }
  }
  return normals;
}

// The direction of the sum; zero if the sum is zero.
function mean_direction(vectors) {
  const sum = [0, 0, 0];
  for (const v of vectors) for (let k = 0; k < 3; ++k) sum[k] += v[k];
  const length = norm(sum) || 1;
  return sum.map((value) => value / length);
}

// At a vertex where faces differ by much, each corner becomes a vertex of its own. Its normal is the mean over the
// faces within the crease angle of its own face. Returns the triangles, the input vertex of each vertex, the normals.
export function smooth_unless_sharp(positions, triangles) {
  const face_normals = normals_of_faces(positions, triangles);
  const number_of_vertices = positions.length / 3;
  const corners_of_vertices = Array.from({ length: number_of_vertices }, () => []);
  triangles.forEach((v, corner) => corners_of_vertices[v].push(corner));
  const index = triangles.slice();
  const source = Array.from({ length: number_of_vertices }, (_, v) => v);
  const normals = Array(positions.length).fill(0);
  for (let v = 0; v < number_of_vertices; ++v) {
    const corners = corners_of_vertices[v];
    const faces = corners.map((corner) => face_normals.subarray(corner - (corner % 3), corner - (corner % 3) + 3));
    const lengths = faces.map(norm);
    const normal = mean_direction(faces);
    for (let k = 0; k < 3; ++k) normals[3 * v + k] = normal[k];
    if (faces.every((face, i) => dot(face, normal) >= Math.cos(crease_angle / 2) * lengths[i])) continue;
    faces.forEach((face, i) => {
      const near = faces.filter((other, j) => dot(face, other) >= Math.cos(crease_angle) * lengths[i] * lengths[j]);
      index[corners[i]] = source.length;
      source.push(v);
      normals.push(...mean_direction(near));
    });
  }
  return { index, source, normals: new Float32Array(normals) };
}
