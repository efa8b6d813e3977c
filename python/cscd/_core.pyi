# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later

import typing

import numpy as np
import numpy.typing as npt

__version__: str

class InputError(ValueError): ...
class FileError(OSError): ...

# Name, default, values and help of each argument.
skeletonize_options: list[tuple[str, str, str, str]]
simplify_options: list[tuple[str, str, str, str]]
evaluate_options: list[tuple[str, str, str, str]]

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
    def simplify(self, options: dict[str, typing.Any], stays_inside: bool) -> Skeleton: ...
    def evaluate(self, options: dict[str, typing.Any]) -> str: ...
    def page(self, title: str) -> str: ...
    def save(self, filename: str) -> None: ...
    def shape_diameters(self) -> list[float]: ...
    def segment(self, parts: int) -> list[int]: ...
    def branches(
        self,
    ) -> list[
        tuple[
            list[int],
            tuple[str, str],
            float,
            float,
            float,
            float,
            float,
            float,
            float,
            float,
            int | None,
            int | None,
        ]
    ]: ...

def find_loops(
    V: npt.NDArray[np.float64], F: npt.NDArray[np.int64], seed: int, min_depth: float
) -> list[tuple[str, float, float, list[list[float]]]]: ...
def skeletonize(
    V: npt.NDArray[np.float64],
    F: npt.NDArray[np.int64] | None,
    normals: npt.NDArray[np.float64] | None,
    edges: npt.NDArray[np.int64] | None,
    options: dict[str, typing.Any],
    progress: typing.Callable[[str, float], object] | None,
) -> Skeleton: ...
def read(
    filename: str,
) -> tuple[
    npt.NDArray[np.float64],
    npt.NDArray[np.int64] | None,
    npt.NDArray[np.float64] | None,
    npt.NDArray[np.int64] | None,
    npt.NDArray[np.float64] | None,
]: ...
