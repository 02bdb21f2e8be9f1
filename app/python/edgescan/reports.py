"""The dicts of reports, for type checkers: the keys of the command line's JSON (docs/reference/command-line.md)."""
from typing import Any, Dict, List, Optional, TypedDict


class Limits(TypedDict):
    min: float
    max: float


class _Info(TypedDict):
    input: str
    name: str
    format: str
    sha256: str
    lines: int
    beams: int
    cells: Dict[str, int]
    range_mm: Limits
    unit_mm: float
    frame: str
    pose: Optional[Dict[str, Any]]
    warnings: List[str]
    geometry: str


class Info(_Info, total=False):
    """Of Scan.info()."""
    axis: str
    line_direction: float
    beam_deg: Dict[str, Any]
    line_deg: Dict[str, Any]
    sensor_m: List[float]
    intensity: Dict[str, Any]
    attached_points: int
    points: Dict[str, int]
    acquisition: Dict[str, Any]
    note: str


class Roughness(TypedDict):
    rough: bool
    folding_share: float
    around_folds: float


class RockBorders(TypedDict):
    strong: int
    weak: int
    folds: int
    unknown: int


class _Detected(TypedDict):
    input: str
    sha256: str
    lines: int
    beams: int
    cells: Dict[str, int]
    range_mm: Limits
    settings: Dict[str, Any]
    upper: float
    gray: Dict[str, Any]
    edges: int
    classes: Optional[Dict[str, int]]
    rock_borders: Optional[RockBorders]
    noise_mm_at_5_m: Optional[float]
    noise: Optional[Dict[str, Any]]
    roughness: Optional[Roughness]
    proposed_preset: Optional[str]
    jump_mm: Optional[float]
    edge_mask_sha256: str
    frame: str
    pose: Optional[Dict[str, Any]]
    attached_points: int
    timings_ms: Dict[str, float]
    warnings: List[str]
    version: str


class Detected(_Detected, total=False):
    """Of Result.report()."""
    points: Dict[str, int]
    filled: Dict[str, Any]


_Class = TypedDict("_Class", {"class": Optional[str]})


class Why(_Class):
    """Of why()."""
    input: str
    line: int
    beam: int
    state: str
    range_mm: Optional[float]
    gray: int
    smoothed: Optional[float]
    takes_part: bool
    method: str
    edge: bool
    gradient: Optional[Dict[str, Any]]
    rough_around: Optional[Dict[str, float]]
    measured: Optional[Dict[str, Any]]
    response_class: Optional[str]
    round_gap: bool
    border: Optional[Dict[str, Any]]
    unit: str
    strength: float
    thresholds: Dict[str, Any]
    against_thresholds: str
    suppressed_by: Optional[Dict[str, Any]]
    chain: List[Dict[str, Any]]
    chain_cells: int
    chain_strongest: Optional[Dict[str, Any]]
    appears_at: Optional[Dict[str, float]]
    verdict: str
    text: List[str]


class Region(TypedDict):
    change: str
    by_m: float
    tolerance_m: float
    area_m2: float
    cells: int
    line: int
    beam: int
    range_m: float
    lines: List[int]
    beams: List[int]
    mine: Optional[List[float]]


class Compared(TypedDict):
    """Of compare()."""
    before: str
    now: str
    lined_up_by: str
    same_cells: bool
    surfaces: Optional[Dict[str, Any]]
    out_of_spec: bool
    warnings: List[str]
    edges: Dict[str, int]
    cells: Optional[Dict[str, int]]
    median_difference_mm: Optional[float]
    change_limit_mm: Optional[Dict[str, float]]
    regions: List[Region]


class _Rock(TypedDict):
    rock: int
    line: int
    beam: int
    cells: int
    visible_long_m: float
    visible_wide_m: float
    tolerance_m: float
    distance_m: float
    visible_area_m2: float
    unoccluded_share: float
    in_front_of: List[int]
    behind: List[int]
    contacts_at_least: List[int]
    touches_other: bool
    free_below_at_least_m: Optional[float]
    arch_deg: Optional[float]
    arch_tolerance_deg: Optional[float]
    hangs_below: Optional[bool]
    finer_share: float
    confidence: float
    by_hand: bool
    note: str
    apart_m: Optional[float]
    may_be_one_with: List[int]
    names: Optional[str]
    up_assumed: bool


class Rock(_Rock, total=False):
    """A row of Rocks.table; its coordinates are those of one frame."""
    easting_m: float
    northing_m: float
    elevation_m: float
    x_m: float
    y_m: float
    z_m: float
    east_m: float
    north_m: float
    up_m: float


class RockRegion(TypedDict):
    """A row of Rocks.region_table."""
    region: int
    kind: str
    cells: int
    visible_area_m2: float
    four_sd_m: float
    evidence: float
    confidence: float


class Status(TypedDict):
    """Of Connection.status."""
    phase: str
    sentence: str
    scanner: Optional[str]
    lines: int
    undecodable: int
    reconnects: int
    sweep: str
    recording: bool


class Parameter(TypedDict):
    """A row of parameters()."""
    key: str
    label: str
    unit: str
    help: str
    minimum: float
    maximum: float
    default: str
    automatic: bool
    choices: List[str]
    several: bool
