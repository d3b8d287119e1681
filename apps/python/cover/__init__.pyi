import os
from typing import Any, Callable, Literal, Mapping, Optional, Sequence, Tuple, TypedDict, Union

import numpy as np
import numpy.typing as npt
from typing_extensions import Unpack

__all__ = ["Cancelled", "Error", "Mesh", "OptionError", "OutOfMemory", "RequirementNotMet", "mesh", "mesh_file",
           "mesh_polygons", "options", "read", "read_options", "write_options"]

__version__: str

_Progress = Callable[[str, int, int], Optional[bool]]
_Material = Union[str, int]
_Region = Union[Tuple[float, float, _Material], Tuple[float, float, _Material, str]]
_Path = Union[npt.ArrayLike, Sequence[Union[Tuple[float, float], Mapping[str, Any]]]]  # with arcs and circles
_Rings = Sequence[_Path]
_Sizes = Union[float, str, Sequence[str], Mapping[str, Union[float, str]]]
_Layers = Union[str, Sequence[str], Mapping[str, Union[str, Sequence[float]]]]
_Only = Union[str, int, Sequence[Union[str, int]]]
_Onto = Union["Mesh", str, os.PathLike[str]]
_Polygon = Union[Tuple[_Material, _Rings], Tuple[_Material, _Rings, str], Mapping[str, Any]]

class _Options(TypedDict, total=False):
    method: Literal["quality", "almond", "nonobtuse"]
    fill: Literal["refine", "disks"]
    max_angle: float  # degrees, as all angles
    min_angle: float
    prefer: Literal["balanced", "largest"]
    effort: Literal["fast", "normal", "thorough"]
    couplings: Literal["auto", "first", "last"]
    growth: Optional[float]
    size: _Sizes  # by region or material; "" is everywhere; an expression of x and y for a length
    sizes: _Sizes  # the same
    size_at: _Sizes  # by contact, interface or point
    sizes_at: _Sizes
    no_input_sizes: bool
    input_sizes: bool
    size_field: Union[None, str, os.PathLike[str], Callable[[float, float], float]]  # a function of x and y: a length
    size_of: Optional[str]  # "asinh", "asinh(doping)"
    size_step: float
    min_size: Optional[float]
    box_method: bool
    layers: _Layers  # by line, or line@region: first, growth[, count]
    split_interfaces: Union[None, bool, float]
    overlap: Literal["last", "first", "error"]
    weld: Union[None, float, str]  # "auto", "off"
    # "left=right" or ("left", "right"), "a=b@x,y:degrees", "a=b@mirror"
    periodic: Union[str, Sequence[Union[str, Tuple[str, str]]]]
    strict: bool
    merge_materials: bool
    hull: bool
    paper: bool
    pieces: int
    require: Union[str, Sequence[str]]
    threads: int

class _ReadOptions(TypedDict, total=False):
    unit: Literal["nm", "um", "mm", "cm", "m"]
    scale: float
    input_format: str
    layer: Union[str, Sequence[str]]
    layer_map: Union[str, os.PathLike[str], Sequence[Union[str, os.PathLike[str]]]]
    label_layer: str
    cell: str
    window: Union[str, Tuple[float, float, float, float]]
    chord_error: float
    chord_angle: float  # degrees
    material_field: str
    name_field: str
    priority_field: str
    keep_field: Union[str, Sequence[str]]
    crs: str
    speckle: int
    no_smooth: bool
    legend: Union[str, os.PathLike[str]]

class _FileOptions(_Options, _ReadOptions, total=False): ...

class _WriteOptions(TypedDict, total=False):
    order: Literal[1, 2]
    inner_lines: bool
    no_inner_lines: bool
    lines: bool
    msh: Literal["2.2", "4.1"]
    xdmf: Literal["text", "hdf5"]
    ids: Literal["region", "material", "name"]
    inp_element: Literal["S", "CPS", "CPE", "CAX"]
    parts: int

class _SaveOptions(_WriteOptions, total=False):
    title: Optional[str]  # of pictures, as what follows
    width: Optional[int]  # pixels
    color: Optional[str]  # an array that is shown by colour: "max_angle"

class _Line(TypedDict):
    left: int
    right: int
    edges: npt.NDArray[np.uint32]

class _RegionNames(TypedDict):
    id: int
    name: str
    material: int
    material_name: str

class Error(Exception):
    code: int
    where: Sequence[Tuple[float, float]]
    inputs: Sequence[Tuple[str, int]]  # kind and id: "point", "segment", "polygon", "hole", "region", "line"

class OptionError(Error, ValueError, TypeError): ...
class OutOfMemory(Error, MemoryError): ...
class Cancelled(Error): ...

class RequirementNotMet(Error):
    mesh: Mesh  # that was made

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
    def lines(self) -> dict[str, list[_Line]]: ...
    @property
    def named_points(self) -> dict[str, npt.NDArray[np.int64]]: ...  # indices into points
    @property
    def periodic(self) -> list[dict[str, Any]]: ...  # "from", "to", "vertices" (pairs), "edges"
    @property
    def arcs(self) -> dict[str, Any]: ...  # "edges" on arcs, their "middles", "straight" ones, "areas"
    @property
    def attributes(self) -> dict[str, Union[npt.NDArray[np.float64], list[Optional[str]]]]: ...  # keep_field, by region
    @property
    def fields(self) -> dict[str, npt.NDArray[np.float64]]: ...  # what the input has beside geometry: doping, by point
    @property
    def regions(self) -> list[_RegionNames]: ...
    @property
    def materials(self) -> dict[int, str]: ...
    @property
    def report(self) -> dict[str, Any]: ...
    @property
    def notes(self) -> list[str]: ...  # what `cover mesh` would warn of
    def save(self, path: Union[str, os.PathLike[str]], **options: Unpack[_SaveOptions]) -> None: ...
    def violations(self) -> list[str]: ...  # ValueError for a mesh that was read, copied or pickled
    def box_method(self) -> dict[str, npt.NDArray[Any]]: ...  # couplings of edges, areas of boxes
    def to_vtk(self) -> Any: ...
    def to_meshio(self) -> Any: ...

def mesh(
    points: npt.ArrayLike,
    segments: npt.ArrayLike,
    regions: Optional[Sequence[_Region]] = (),
    holes: Optional[npt.ArrayLike] = (),
    *,
    lines: Optional[Mapping[str, npt.ArrayLike]] = None,
    progress: Optional[_Progress] = None,
    only: Optional[_Only] = None,
    onto: Optional[_Onto] = None,
    **options: Unpack[_Options],
) -> Mesh: ...
def mesh_polygons(
    polygons: Sequence[_Polygon],
    *,
    lines: Optional[Mapping[str, Union[_Path, Sequence[_Path]]]] = None,
    holes: Optional[npt.ArrayLike] = (),
    points: Optional[npt.ArrayLike] = (),
    chord_error: Optional[float] = None,
    unit: Optional[Literal["nm", "um", "mm", "cm", "m"]] = None,
    progress: Optional[_Progress] = None,
    only: Optional[_Only] = None,
    onto: Optional[_Onto] = None,
    **options: Unpack[_Options],
) -> Mesh: ...
def read(path: Union[str, os.PathLike[str]]) -> Mesh: ...
def options() -> list[dict[str, Any]]: ...
def read_options() -> list[dict[str, Any]]: ...
def write_options() -> list[dict[str, Any]]: ...
def mesh_file(
    path: Union[str, os.PathLike[str], Sequence[Union[str, os.PathLike[str]]]],
    *,
    progress: Optional[_Progress] = None,
    only: Optional[_Only] = None,
    onto: Optional[_Onto] = None,
    **options: Unpack[_FileOptions],
) -> Mesh: ...
