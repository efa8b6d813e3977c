// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The types of the package, checked by TypeScript.

import { skeletonize, type Options, type Skeleton } from 'cscd';
const options: Options = { detail: 0.4, root: [0, 0, 0], onProgress: (stage: string, part: number) => void 0 };
const s: Skeleton = await skeletonize(new Float32Array(9), [0, 1, 2], options);
const nodes: Float64Array = s.nodes;
// @ts-expect-error: no such option
await skeletonize([], null, { details: 1 });
