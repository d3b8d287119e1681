from os import PathLike
from typing import Any, Callable, Literal, Mapping, Optional, Sequence, Tuple, TypedDict, Union

import numpy as np
import numpy.typing as npt

Progress = Callable[[str, int, int], Optional[bool]]
Material = Union[str, int]
Region = Union[Tuple[float, float, Material], Tuple[float, float, Material, str]]
Polygon = Union[Tuple[Material, Sequence[npt.ArrayLike]], Tuple[Material, Sequence[npt.ArrayLike], str]]

class Error(Exception):
    code: int
    where: Sequence[Tuple[float, float]]

class Cancelled(Error): ...

class Line(TypedDict):
    left: int
    right: int
    edges: npt.NDArray[np.uint32]

class Mesh:
    @property
    def points(self) -> npt.NDArray[np.float64]: ...
    @property
    def triangles(self) -> npt.NDArray[np.uint32]: ...
    @property
    def region(self) -> npt.NDArray[np.int64]: ...
    @property
    def material(self) -> npt.NDArray[np.int64]: ...
    @property
    def input_id(self) -> npt.NDArray[np.int64]: ...
    @property
    def lines(self) -> dict[str, list[Line]]: ...
    @property
    def report(self) -> dict[str, Any]: ...
    def save(self, path: str) -> None: ...
    def violations(self) -> list[str]: ...

def mesh(
    points: npt.ArrayLike,
    segments: npt.ArrayLike,
    regions: Sequence[Region] = ...,
    holes: npt.ArrayLike = ...,
    *,
    progress: Optional[Progress] = ...,
    method: Literal["quality", "almond", "nonobtuse"] = ...,
    fill: Literal["refine", "disks"] = ...,
    max_angle: float = ...,
    min_angle: float = ...,
    growth: float = ...,
    sizes: Mapping[str, float] = ...,
    overlap: Literal["last", "first", "error"] = ...,
    weld: Union[None, float, Literal["auto", "off"]] = ...,
    strict: bool = ...,
    merge_materials: bool = ...,
    hull: bool = ...,
    threads: int = ...,
) -> Mesh: ...
def mesh_polygons(
    polygons: Sequence[Polygon], *, progress: Optional[Progress] = ..., **options: Any
) -> Mesh: ...
def mesh_file(
    path: Union[str, PathLike[str]], *, progress: Optional[Progress] = ..., **options: Any
) -> Mesh: ...
