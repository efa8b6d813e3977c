# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later

import numpy as np
import numpy.typing as npt

__version__: str

class InputError(ValueError): ...
class FileError(OSError): ...

class SkeletonizeOptions:
    method: str
    literal: bool
    shape: str
    borders: str
    wrap: float | None
    domain: str
    neighbors: int
    root: str
    detail: float | None
    seed: int
    threads: int
    separators: int
    min_component: int
    join: bool
    def __init__(self) -> None: ...

class SimplifyOptions:
    min_significance: float
    min_length: float
    min_length_over_radius: float
    merge_junctions: float
    spacing: float
    spacing_over_radius: float
    smooth: int
    min_component: int
    join: bool
    def __init__(self) -> None: ...

class Skeleton:
    @property
    def nodes(self) -> npt.NDArray[np.float64]: ...
    @property
    def radius(self) -> npt.NDArray[np.float64]: ...
    @property
    def edges(self) -> npt.NDArray[np.int32]: ...
    @property
    def significance(self) -> npt.NDArray[np.float64]: ...
    @property
    def vertex_to_node(self) -> npt.NDArray[np.int32]: ...
    @property
    def report(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def repairs(self) -> list[str]: ...
    def simplify(self, options: SimplifyOptions, stays_inside: bool) -> Skeleton: ...
    def evaluate(self, radii: str, resolution: int) -> str: ...
    def page(self, title: str) -> str: ...
    def save(self, filename: str) -> None: ...
    def shape_diameters(self) -> list[float]: ...
    def segment(self, parts: int) -> list[int]: ...
    def branches(self) -> list[tuple[list[int], tuple[str, str], float, float, float, float, float, float]]: ...

def find_loops(
    V: npt.NDArray[np.float64], F: npt.NDArray[np.int64], seed: int, min_depth: float
) -> list[tuple[str, float, float, list[list[float]]]]: ...
def skeletonize(
    V: npt.NDArray[np.float64],
    F: npt.NDArray[np.int64] | None,
    normals: npt.NDArray[np.float64] | None,
    edges: npt.NDArray[np.int64] | None,
    options: SkeletonizeOptions,
) -> Skeleton: ...
