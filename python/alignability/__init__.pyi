# SPDX-License-Identifier: BSD-3-Clause
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

_Path = str | os.PathLike[str]
_Pose = tuple[float, float, float]
_PoseLike = Sequence[float] | NDArray[Any]
_Progress = Callable[[int, int], object]
_Engine = Literal["native", "pcl"]
_Dimensions = Literal["automatic", "two", "three"]
_Moment = Literal["about_origin", "about_mean"]
_Reading = Literal["centred", "voxel", "robust", "information"]
_Geometry = Literal["visual", "collision"]
_Axis = Literal["x", "y", "z"]
_Space = Literal["r2", "se2", "dubins", "reeds_shepp"]
_Unknown = Literal["risky", "neutral", "blocked"]
_Localizer = Literal["ndt_mcl_sum", "ndt_mcl_product", "scan_matching"]
_Status = Literal[
    "solved",
    "no_path",
    "timeout",
    "infeasible",
    "start_in_collision",
    "goal_in_collision",
    "start_outside_map",
    "goal_outside_map",
]

class InputError(ValueError):
    file: str
    line: int
    column: int

class OccupancyMap:
    @staticmethod
    def load(path: _Path) -> OccupancyMap: ...
    @staticmethod
    def from_array(occupancy: ArrayLike, resolution: float, origin: Sequence[float] = ...) -> OccupancyMap: ...
    def save(self, path: _Path) -> None: ...
    @property
    def occupancy(self) -> NDArray[np.float32]: ...
    @property
    def resolution(self) -> float: ...
    @property
    def origin(self) -> tuple[float, float]: ...
    @property
    def shape(self) -> tuple[int, int]: ...

class AlignabilityMap:
    @staticmethod
    def load(path: _Path) -> AlignabilityMap: ...
    @staticmethod
    def from_array(alpha: ArrayLike, resolution: float, origin: Sequence[float] = ...) -> AlignabilityMap: ...
    def save(self, path: _Path) -> None: ...
    def layer(self, name: str) -> NDArray[np.float32]: ...
    @property
    def alpha(self) -> NDArray[np.float32]: ...
    @property
    def layers(self) -> list[str]: ...
    @property
    def resolution(self) -> float: ...
    @property
    def origin(self) -> tuple[float, float]: ...
    @property
    def shape(self) -> tuple[int, int]: ...
    @property
    def seed(self) -> int: ...
    @property
    def options(self) -> str: ...
    @property
    def sensor(self) -> str: ...
    @property
    def provenance(self) -> str: ...

class Scene:
    @staticmethod
    def load(
        path: _Path,
        *,
        model_paths: Sequence[_Path] = [],
        geometry: _Geometry = "collision",
        unit: float | None = None,
        up_axis: _Axis | None = None,
        level: bool = False,
        thinning: float | None = None,
    ) -> Scene: ...

class Score:
    @property
    def alpha(self) -> float: ...
    @property
    def dimensions(self) -> int: ...
    @property
    def eigenvalues(self) -> NDArray[np.float64]: ...
    @property
    def weakest_direction(self) -> NDArray[np.float64]: ...
    @property
    def planes_found(self) -> int: ...
    @property
    def planes_kept(self) -> int: ...
    @property
    def points(self) -> int: ...
    @property
    def readings(self) -> dict[_Reading, float]: ...
    @property
    def plane_of_point(self) -> NDArray[np.int32]: ...
    @property
    def normals(self) -> NDArray[np.float32]: ...

class Robot:
    radius: float
    footprint: list[NDArray[np.float64]]
    def __init__(self, *, radius: float = ..., footprint: Sequence[_PoseLike] = ...) -> None: ...

class Motion:
    space: _Space
    turn_cost: float
    turning_radius: float
    reverse_penalty: float
    def __init__(
        self, *, space: _Space = ..., turn_cost: float = ..., turning_radius: float = ..., reverse_penalty: float = ...
    ) -> None: ...

class GoalTolerance:
    position: float
    heading: float
    def __init__(self, *, position: float = ..., heading: float = ...) -> None: ...

class RiskOptions:
    alpha_critical: float
    alpha_safe: float
    unknown: _Unknown
    min_alpha: float | None
    alpha_weight: float
    def __init__(
        self,
        *,
        alpha_critical: float = ...,
        alpha_safe: float = ...,
        unknown: _Unknown = ...,
        min_alpha: float | None = ...,
        alpha_weight: float = ...,
    ) -> None: ...

class PlannerChoice:
    name: str
    time: float
    iterations: int | None
    seed: int
    def __init__(self, *, name: str = ..., time: float = ..., iterations: int | None = ..., seed: int = ...) -> None: ...

class Problem:
    robot: Robot
    start: _Pose
    goal: _Pose
    motion: Motion
    goal_tolerance: GoalTolerance
    weight: float
    max_error: float | None
    max_blind_distance: float | None
    recovery_distance: float
    risk: RiskOptions
    planner: PlannerChoice
    scene: os.PathLike[str] | None
    sensor: os.PathLike[str] | None
    drive: os.PathLike[str] | None
    range_max: float | None
    def __init__(
        self,
        occupancy: OccupancyMap,
        alignability: AlignabilityMap,
        robot: Robot,
        start: _PoseLike,
        goal: _PoseLike,
        *,
        motion: Motion = ...,
        goal_tolerance: GoalTolerance = ...,
        weight: float = ...,
        max_error: float | None = ...,
        max_blind_distance: float | None = ...,
        recovery_distance: float = ...,
        risk: RiskOptions = ...,
        planner: PlannerChoice = ...,
    ) -> None: ...
    @staticmethod
    def load(path: _Path) -> Problem: ...
    def copy(self) -> Problem: ...
    @property
    def occupancy(self) -> OccupancyMap: ...
    @property
    def alignability(self) -> AlignabilityMap: ...

class PathFigures:
    @property
    def length(self) -> float: ...
    @property
    def turned(self) -> float: ...
    @property
    def backward_length(self) -> float: ...
    @property
    def risk_integral(self) -> float: ...
    @property
    def blind_length(self) -> float: ...
    @property
    def longest_blind(self) -> float: ...
    @property
    def evaluated_length(self) -> float: ...
    @property
    def alpha_mean(self) -> float: ...
    @property
    def alpha_min(self) -> float: ...

class PlanResult:
    @property
    def status(self) -> _Status: ...
    @property
    def solved(self) -> bool: ...
    @property
    def poses(self) -> NDArray[np.float64]: ...
    @property
    def cost(self) -> float | None: ...
    @property
    def figures(self) -> PathFigures | None: ...
    @property
    def risk_by_source(self) -> dict[str, float] | None: ...
    @property
    def lower_bound(self) -> float | None: ...
    @property
    def predicted_error(self) -> float | None: ...
    @property
    def longest_unrecovered(self) -> float | None: ...
    @property
    def smallest_max_error(self) -> float | None: ...
    @property
    def smallest_max_blind_distance(self) -> float | None: ...
    @property
    def greatest_min_alpha(self) -> float | None: ...
    @property
    def seconds(self) -> float: ...
    @property
    def first_solution_seconds(self) -> float | None: ...
    @property
    def planner(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def weight(self) -> float: ...

class Comparison:
    @property
    def shortest(self) -> PlanResult: ...
    @property
    def risk_aware(self) -> PlanResult: ...
    @property
    def solved(self) -> bool: ...
    @property
    def length_ratio(self) -> float | None: ...

class RiskField:
    def __init__(self, problem: Problem) -> None: ...
    @property
    def has_headings(self) -> bool: ...
    def risk(self, poses: ArrayLike) -> NDArray[np.float64]: ...
    def alpha(self, poses: ArrayLike) -> NDArray[np.float64]: ...
    def integral(self, from_poses: ArrayLike, to_poses: ArrayLike) -> NDArray[np.float64]: ...
    def measure(self, path: ArrayLike) -> PathFigures: ...

class DrivableArea:
    def __init__(self, problem: Problem) -> None: ...
    def contains(self, poses: ArrayLike) -> NDArray[np.bool_]: ...
    def connects(self, from_poses: ArrayLike, to_poses: ArrayLike) -> NDArray[np.bool_]: ...
    def clearance(self, poses: ArrayLike) -> NDArray[np.float64]: ...

class Interval:
    @property
    def value(self) -> float: ...
    @property
    def low(self) -> float: ...
    @property
    def high(self) -> float: ...
    def __float__(self) -> float: ...

class PathErrors:
    @property
    def mean(self) -> Interval: ...
    @property
    def p95(self) -> Interval: ...
    @property
    def max(self) -> Interval: ...
    @property
    def goal(self) -> Interval: ...
    @property
    def lost(self) -> Interval: ...
    @property
    def unsafe(self) -> Interval: ...

class Run:
    @property
    def seconds(self) -> NDArray[np.float64]: ...
    @property
    def s(self) -> NDArray[np.float64]: ...
    @property
    def truth(self) -> NDArray[np.float64]: ...
    @property
    def estimates(self) -> NDArray[np.float64]: ...
    @property
    def errors(self) -> NDArray[np.float64]: ...

class Validation:
    @property
    def localizer(self) -> _Localizer: ...
    @property
    def errors(self) -> PathErrors: ...
    @property
    def by_path(self) -> dict[str, PathErrors]: ...
    @property
    def runs(self) -> dict[str, list[Run]]: ...
    @property
    def cells(self) -> NDArray[Any]: ...
    @property
    def rank_correlations(self) -> dict[str, Interval]: ...

def score(
    points: ArrayLike,
    *,
    sensor: _Path | None = None,
    range_min: float = 0.5,
    range_stddev: float = 0.02,
    dimensions: _Dimensions = "automatic",
    normal_neighbours: int = 30,
    growing_neighbours: int = 15,
    smoothness: float = 0.05235987755982988,
    curvature: float = 1.0,
    min_points: int = 50,
    min_line_points: int = 10,
    stride: int = 1,
    engine: _Engine = "native",
    plane_threshold: float = 0.05,
    min_area: float = 0.01,
    min_length: float = 0.1,
    moment: _Moment = "about_origin",
    readings: Sequence[_Reading] = [],
    voxel: float = 0.08,
) -> Score: ...
def build_map(
    scene: _Path | Scene,
    sensor: _Path,
    occupancy: _Path | OccupancyMap,
    *,
    resolution: float = 1.0,
    samples: int = 10,
    range_max: float | None = None,
    headings: int | None = None,
    floor: float = 0.0,
    seed: int = 1,
    occupied_above: float = 0.5,
    max_occupied_share: float = 0.5,
    cells: Sequence[tuple[int, int]] | None = None,
    checkpoint: _Path | None = None,
    threads: int = 0,
    progress: _Progress | None = None,
    normal_neighbours: int = 30,
    growing_neighbours: int = 15,
    smoothness: float = 0.05235987755982988,
    curvature: float = 1.0,
    min_points: int = 50,
    min_line_points: int = 10,
    stride: int = 1,
    engine: _Engine = "native",
    plane_threshold: float = 0.05,
    min_area: float = 0.01,
    min_length: float = 0.1,
    moment: _Moment = "about_origin",
    readings: Sequence[_Reading] = [],
    voxel: float = 0.08,
) -> AlignabilityMap: ...
def plan(problem: Problem) -> PlanResult: ...
def compare(problem: Problem) -> Comparison: ...
def read_scan(path: _Path) -> NDArray[np.float32]: ...
def simulate_scan(
    scene: _Path | Scene,
    sensor: _Path,
    pose: _PoseLike,
    *,
    range_max: float | None = None,
    floor: float = 0.0,
    seed: int | None = None,
) -> NDArray[np.float32]: ...
def validate(
    problem: Problem,
    paths: Mapping[str, ArrayLike],
    *,
    runs: int = 20,
    seed: int = 1,
    localizers: Sequence[_Localizer] = [],
    floor: float = 0.0,
    threads: int = 0,
    progress: _Progress | None = None,
) -> list[Validation]: ...
