// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

/** The options of `cscd skeletonize` that apply. None has a unit: lengths are relative to the shape. */
export interface Options {
  /** How small a limb may be to get a branch: from 0, none, to 1, every bump. By default 0.5. */
  detail?: number;
  /** Seed of the random choice of sources. By default 0. */
  seed?: number;
  /** Of a mesh: bridge its borders, or let components with borders be sheets. By default 'auto'. */
  borders?: 'auto' | 'bridge' | 'open';
  /** What points sample: the surface of a body, or trees. By default 'auto'. */
  shape?: 'auto' | 'surface' | 'tree';
  /** Where the skeleton begins, for the parents of branches in the report. */
  root?: [number, number, number] | 'thickest' | 'lowest' | 'longest';
  /** Drop components of less vertices or points than this, except the largest. */
  minComponent?: number;
  /** Join components by the shortest straight edges. */
  join?: boolean;
  /** Greatest number of sources of separators. */
  separators?: number;
  /** Ends the work: the promise is rejected with the reason of the signal. */
  signal?: AbortSignal;
  /** Called with the name of a stage and the part of it that is done, from 0 to 1. An error that it throws ends the work. */
  onProgress?: (stage: string, fraction: number) => void;
}

/** A curve skeleton, in the coordinates of the input. */
export interface Skeleton {
  /** Three coordinates of each node. */
  nodes: Float64Array;
  /** The mean distance from the curve to the surface around each node. */
  radii: Float64Array;
  /** The two nodes of each edge. */
  edges: Uint32Array;
  /** The node of each vertex or point of the input; -1 for none, as for vertices without a face. */
  vertexToNode: Int32Array;
  /** Counts, branches, seconds, repairs and warnings: the object that `cscd skeletonize --report` writes. */
  report: Record<string, any>;
}

/**
 * Computes the curve skeleton of a mesh, or of points, in a worker of its own. Arrays are copied. Near linear.
 *
 * @param positions three coordinates of each vertex or point, in any unit
 * @param indices the vertices of each triangle, counterclockwise seen from outside; null for points
 * @returns a promise. It is rejected with a TypeError, RangeError or Error whose message names the element and the
 *   remedy if an argument cannot be obeyed or the input cannot be skeletonized.
 */
export function skeletonize(
  positions: ArrayLike<number>,
  indices: ArrayLike<number> | null,
  options?: Options,
): Promise<Skeleton>;
