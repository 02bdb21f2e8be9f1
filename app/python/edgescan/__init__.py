"""Edges of rocks in laser range scans.

>>> import edgescan
>>> bell = edgescan.simulate(seed=7, lines=120, beams=161, truth=True)
>>> result = edgescan.detect(bell.scan, jump=40, min_length=8)
>>> result.mask.shape, str(result.mask.dtype)
((120, 161), 'uint8')
>>> result.scan.xyz()[result.mask > 0].shape[1]   # the edge points, metres
3
>>> bool((bell.truth["edge_class"] > 0).any())    # what it should find
True

Arrays are lines x beams: cell (line, beam) is one pixel, one measurement, one point. They look into the scan without a copy and cannot be
written to. Ranges are millimetres, points metres, angles degrees. What is refused raises edgescan.Error with the sentence that the command
line prints, with keywords for flags: names of flags have _ where the command line has -.
"""
from __future__ import annotations

import json as _json
import os as _os
from typing import Any, Dict, Iterable, List, Literal, Optional, Tuple, Union

from ._edgescan import Connection, Error, Replay, Result, Rocks, Scan, Simulation, Sweep, __version__
from . import _arrays, _edgescan, _methods
from ._lab import benchmark
from .reports import Compared, Parameter, Why
from ._values import Path, answers_missing as _answers_missing, each as _each, ending as _ending, keywords as _keywords, path as _path, public as _public, refuse as _refuse, whole as _whole, word as _word

__all__ = ["Connection", "Error", "FileError", "Replay", "Result", "Rocks", "Scan", "Simulation", "Sweep", "benchmark", "compare", "connect", "detect",
           "open", "parameters", "presets", "replay", "report", "rocks", "save", "simulate", "why"]

_READING = _edgescan.reading_options()
_PARAMETERS = _edgescan.parameters()
_NAMES = [dict(row, key=name) for name, key in _edgescan.other_names().items() for row in _PARAMETERS if row["key"] == key]
_CHOICES = [dict(row, kind="switch") for row in _edgescan.writing_choices()]
_ROCKS = [dict(row, kind="float") for row in _edgescan.rock_parameters()]
_NUMBERS = [dict(row, kind="float", default=f"{row['default']:g}") for row in _edgescan.simulation_numbers()]

for _made in (Connection, Replay, Result, Rocks, Scan, Simulation, Sweep):
    _answers_missing(_made)
Scan.__doc__ = _arrays.scan.__doc__
Scan.__signature__ = _arrays.made.__signature__


class FileError(Error, FileNotFoundError):
    """A file to read that is not there: an Error and a FileNotFoundError."""


def _read(read, path, *more):
    try:
        return read(path, *more)
    except Error as error:
        if _os.path.exists(path):
            raise
        lost = FileError(str(error))
        lost.what, lost.where, lost.hint = error.what, error.where, error.hint
        raise lost from None


def _switches(**values):
    return {key.replace("_", "-"): "on" if value else "off" for key, value in values.items()}


@_public
def parameters() -> List[Parameter]:
    """The table of parameters: a list of dicts with key, label, unit, help, minimum, maximum, default, automatic, choices, several.

    Each key is a keyword of detect(), with _ for -.
    """
    return _edgescan.parameters()


@_public
def presets() -> List[str]:
    """Names of the built-in presets."""
    return _edgescan.presets()


@_keywords(("Reading, as the flags of the command line:", _READING))
def open(path: Path, **reading) -> Scan:
    """Opens any readable file as a Scan. Its content decides what it is.

    >>> scan = edgescan.open(path)
    >>> scan.range_mm.shape == scan.state.shape == (scan.lines, scan.beams)
    True
    """
    return _read(_edgescan.open, path, reading)


@_keywords(("Parameters, as the sliders of the viewer and the flags of the command line:", _PARAMETERS),
           ("Other names:", _NAMES))
def detect(scan: Scan, *, preset: Optional[Path] = None, **parameters) -> Result:
    """Finds the edges of a Scan; the same mask bit by bit as `edgescan-cli detect`. Returns a Result.

    preset: name of a built-in preset, or a preset file; the parameters that are given come on top of it.

    Other Python threads run meanwhile. OpenCV's thread pool is off in this process from the first call on.

    >>> result = edgescan.detect(scan, method="canny", lower=10)
    >>> bool(((result.strength >= 10) == (result.mask > 0)).all())
    True
    """
    return _edgescan.detect(scan, parameters, preset or b"")


@_public
def why(result: Result, line: int, beam: int) -> Why:
    """Why a cell is an edge, or why it is not: the JSON of `edgescan-cli why` as a dict; "verdict" is the sentence.

    >>> line, beam = divmod(int(result.edges[0]), result.scan.beams)
    >>> edgescan.why(result, line, beam)["edge"]
    True
    """
    return _edgescan.why(result, line, beam)


@_public
def compare(before: Result, now: Result, *, poses: Optional[Tuple[Path, Path]] = None, by_surfaces: bool = False,
            picture: Optional[Path] = None) -> Compared:
    """What changed between two scans of one place, before and after a blast: edges gained and lost, surfaces nearer and farther. The JSON of
    `edgescan-cli compare --json` as a dict.

    poses: the two .pose files of 3DTK, in the order of the results; else the places that the scans have. by_surfaces: line the scans up by
    their surfaces, also where there are poses. picture: new PNG on the grid of `now`.

    >>> edgescan.compare(result, result)["edges"]["gained"]
    0
    """
    files = [] if poses is None else [_path("compare(): poses", file) for file in _each("compare(): poses", "two paths", poses)]
    if len(files) not in (0, 2):
        raise TypeError(f"compare(): poses must be two paths, not {len(files)}")
    if picture is not None:
        _ending(picture, b".png", "the picture is a PNG")
    return _edgescan.compare(before, now, files, by_surfaces, picture or b"")


@_public
def report(result: Result, path: Path, *, rocks: Optional[Rocks] = None, targets: Optional[Path] = None, before: Optional[Scan] = None,
           operator: str = "", role: str = "") -> int:
    """Writes one HTML page about a Result, as `edgescan-cli report`; it opens in any browser. Returns its bytes. Result.report() is the JSON.

    rocks: a Rocks, for a page with the rocks of its settings. targets: the viewer's file of targets. before: an earlier Scan of the place,
    for what changed since, by the same settings. operator, role: who makes the report.

    >>> edgescan.report(result, folder / "report.html") > 10000
    True
    """
    if not path.lower().endswith(b".htm"):
        _ending(path, b".html", "the report is HTML", "; a browser prints it as PDF")
    if rocks is not None:
        _edgescan.rocks_of_scan(rocks, result)
    return _edgescan.report(result, path, _json.dumps(rocks.settings) if rocks is not None else "", targets or b"", before, operator, role)


@_keywords(("Parameters of rocks:", _ROCKS))
def rocks(result: Result, *, region: Union[None, str, Iterable[Iterable[int]]] = None, **parameters) -> Rocks:
    """Rocks from a Result's edges: a Rocks with labels and a row per rock. Candidates, geometry only, from one viewpoint.

    region: cells (line, beam), two opposite corners or a polygon; what lies mostly outside counts as nothing. A Result of another method
    than EdgeScan+ gives the rocks of EdgeScan+ with the same settings.

    >>> found = edgescan.rocks(result, min_cells=60)
    >>> found.count == int(found.labels.max()) == len(found.table)
    True
    >>> found.at(2.0).settings["level"] == 2   # coarser, at once
    True
    """
    if region is not None and not isinstance(region, str):
        cells = [_each("rocks(): region", "a list of cells", cell) for cell in _each("rocks(): region", "a str or a list of cells", region)]
        if any(len(cell) != 2 for cell in cells):
            raise TypeError("rocks(): region must be a list of cells (line, beam), and one of them does not have two numbers")
        region = " ".join(f"{_whole('rocks(): region', line)},{_whole('rocks(): region', beam)}" for line, beam in cells)
    return _edgescan.rocks(result, parameters, _word("rocks(): region", region or ""))


@_keywords(("Choices of single formats, True or False:", _CHOICES))
def save(what: Union[Scan, Result], path: Path, content: Optional[str] = None, *, frame: Literal["auto", "scanner", "local", "mine"] = "auto",
         ascii: bool = False, include_attached: bool = False, operator: str = "", role: str = "", **choices) -> int:
    """Writes a Scan or a Result, with its record inside it and next to it; what was there before stays if that fails.

    content: of a Result 'edges' (the edge points), 'cloud' (all points), 'mask', 'gray', 'range' (PNG) or 'scan' (every cell with its
    state); a Scan is always written whole. Without it .png is the mask, all else the edge points. The extension chooses the format.
    frame: 'mine', 'local', 'scanner', or 'auto': 'mine' if the scan has a place, else 'scanner'. ascii: PCD and PLY as text.
    include_attached: of a cloud that was projected also the points behind the nearest of their cell. operator, role: who exports, for the
    record.

    Returns the number of points or cells written. The file that the scan was opened from is never written over.

    >>> edgescan.save(result, folder / "edges.pcd") == len(result.edges)
    True
    """
    typed = {**choices, **_switches(ascii=ascii, include_attached=include_attached), "frame": frame, "operator": operator, "role": role}
    if isinstance(what, Scan):
        if content not in (None, "scan"):
            _refuse(f'a Scan is always written whole, and "{content}" is of a Result', "content", "detect() first")
        return _edgescan.save_scan(what, path, typed)
    return _edgescan.save_result(what, path, content or ("mask" if path.lower().endswith(b".png") else "edges"), typed)


@_public
def replay(path: Path, *, every: int = 1, speed: float = 0, pose: Path = "", calibration: Path = "") -> Replay:
    """Plays a recording through the path that live telegrams take: an iterator of Sweep.

    A Sweep comes behind every `every` lines, and each sweep once more when it is finished. speed: 1 = as it was recorded, 0 = as fast as
    it goes. pose, calibration: files that give the scan its place; the recording may hold its own.

    >>> for sweep in edgescan.replay(recording, every=50):
    ...     edges = edgescan.detect(sweep.scan).mask
    >>> sweep.finished, sweep.complete
    (True, True)
    """
    return _read(_edgescan.replay, path, every, speed, pose, calibration)


@_public
def connect(address: str, *, record: Path = "", expected_lines: int = 0, axis: Optional[Literal["spin", "sweep"]] = None,
            line_start: Optional[float] = None, line_step: Optional[float] = None, ticks_per_degree: Optional[float] = None,
            calibration: Path = "", stop_and_go: bool = False, timeout: float = 10) -> Connection:
    """Connects to an LMS5xx: an iterator of Sweep, the newest state whenever a line came, and each sweep once more when it is finished.

    address: HOST or HOST:PORT. Nothing but reads and a subscription is sent to it. record: new recording (.mcap) of every telegram.
    expected_lines: of a whole sweep, 0 = not known. axis, line_start, line_step: mounting of the stepper and its angles in degrees, as for
    open(). ticks_per_degree: encoder counts, where there is an encoder. calibration: the robot's file, which says axis and step. What
    neither says is assumed; the scan's warnings and the recording report it. stop_and_go: the stepper stops while a line is measured.

    timeout: seconds, 0 = for ever. connect() waits for the first scan line of the scanner, and raises edgescan.Error if it does not come in this time. So
    does the iterator if the sweep does not change for this time. The error says what the session waits for; while it waits, the logger
    "edgescan" warns about each new problem of the connection.

    The session ends with stop(), or at the end of a with block. A lost connection is made again by itself.

    >>> with edgescan.connect(address, expected_lines=40, timeout=30) as scanner:
    ...     for sweep in scanner:
    ...         if sweep.finished:
    ...             break
    >>> sweep.scan.lines
    40
    """
    if record:
        _ending(record, b".mcap", "the recording is an MCAP file")
    return _edgescan.connect(address, record, expected_lines, axis, line_start, line_step, ticks_per_degree, calibration, stop_and_go, timeout)


@_keywords(("Numbers, as the flags of the command line:", _NUMBERS))
def simulate(*, seed: int = 1, scene: str = "hangup", axis: Literal["spin", "sweep"] = "sweep",
             profile: Literal["high", "standard"] = "high", hole_shape: Optional[Literal["none", "round", "square"]] = None,
             wall_kind: Optional[str] = None, surface: Optional[Scan] = None, footprint: bool = True, mixed_pixels: bool = True,
             echo_loss: bool = True, after_blast: bool = False, truth: bool = False, **numbers) -> Simulation:
    """A synthetic draw-bell sweep of an LMS511: a Simulation with scan and, where asked for, truth. Same seed, same bytes.

    scene: hangup, pile, empty, wall, staircase or rescan. axis: mounting of the stepper, 'sweep' or 'spin'. profile: beam divergence 'high'
    (resolution, 4.6 mrad) or 'standard' (11 mrad). hole_shape: 'none', 'round' or 'square' holes in the wall. wall_kind: that of the
    bell: plain (where none is given), rough, blocky, bulging, brows, bolted, muck, chimney or tunnel. surface: Scan of a surface seen from above, for the scene
    rescan. footprint, mixed_pixels, echo_loss: False switches that part of the measurement off. after_blast: the hang-up with some rocks
    gone and others fallen.

    >>> edgescan.simulate(seed=3, lines=90, beams=96).scan.range_mm.shape
    (90, 96)
    """
    words = {"scene": scene, "axis": axis, "profile": profile,
             **_switches(footprint=footprint, mixed_pixels=mixed_pixels, echo_loss=echo_loss, after_blast=after_blast, truth=truth)}
    words.update({key: word for key, word in (("hole-shape", hole_shape), ("wall-kind", wall_kind)) if word is not None})
    if not 0 <= seed < 2**64:
        _refuse(f"{seed} is not a seed", "seed", "give a whole number from 0 to 2**64 - 1")
    return _edgescan.simulate(seed, numbers, words, surface)


def __getattr__(name):
    if name == "evaluate":
        raise AttributeError("edgescan.evaluate: scores are in another program now; use edgescan-lab evaluate MASK.png --truth FOLDER --json -")
    if name == "change":
        raise AttributeError("edgescan.change: it is edgescan.compare(before, now)")
    raise AttributeError(f"module 'edgescan' has no attribute {name!r}")
