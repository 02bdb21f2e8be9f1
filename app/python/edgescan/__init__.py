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
line prints. Names of flags have _ where the command line has -.
"""
import difflib as _difflib
import inspect as _inspect
import math as _math
import numbers as _numbers
import os as _os

from ._edgescan import Connection, Error, Replay, Result, Rocks, Scan, Simulation, Sweep, __version__
from . import _edgescan

__all__ = ["Connection", "Error", "Replay", "Result", "Rocks", "Scan", "Simulation", "Sweep", "connect", "detect", "open", "parameters",
           "presets", "replay", "rocks", "save", "simulate"]


def parameters():
    """The table of parameters: a list of dicts with key, label, unit, help, minimum, maximum, default, automatic, choices, several.

    Each key is a keyword of detect(), with _ for -.
    """
    return _edgescan.parameters()


def presets():
    """Names of the built-in presets."""
    return _edgescan.presets()


def _name(key):
    return key.replace("-", "_")


def _refused(name, wanted, value):
    return TypeError(f"{name} must be {wanted}, not {type(value).__name__}")


def _is_bool(value):
    return isinstance(value, bool) or type(value).__name__ in ("bool_", "bool")


def _number(name, value):
    if not isinstance(value, _numbers.Real) or _is_bool(value):
        raise _refused(name, "a number", value)
    try:
        return float(value)
    except OverflowError:
        return _math.inf if value > 0 else -_math.inf


def _whole(name, value):
    if not isinstance(value, _numbers.Integral) or _is_bool(value):
        raise _refused(name, "a whole number", value)
    return int(value)


def _switch(name, value):
    if not _is_bool(value):
        raise _refused(name, "True or False", value)
    return bool(value)


def _word(name, value):
    if not isinstance(value, str):
        raise _refused(name, "a str", value)
    return value


def _path(name, value):
    """The bytes of a path, which need not be UTF-8."""
    try:
        return _os.fsencode(value)
    except TypeError:
        raise _refused(name, "a path: str, bytes or PathLike", value) from None


def _list(name, wanted, values):
    if isinstance(values, (bytes, bytearray, memoryview)):
        raise _refused(name, wanted, values)
    try:
        return list(values)
    except TypeError:
        raise _refused(name, wanted, values) from None


def _number_text(name, value):
    return str(_whole(name, value)) if isinstance(value, _numbers.Integral) else repr(_number(name, value))


def _typed(name, value, row):
    """A value as it is typed on the command line. TypeError if its type is not one of the row's."""
    kind, choices = row.get("kind"), row.get("choices") or []
    if kind == "path":
        return _path(name, value)
    if kind == "switch" or choices == ["off", "on"]:
        if isinstance(value, str) and value in choices:
            return value
        return "on" if _switch(name, value) else "off"
    if isinstance(value, str):
        return value
    if kind == "three numbers":
        return ",".join(_number_text(name, each) for each in _list(name, "a str or three numbers", value))
    if row.get("several"):
        return ",".join(_word(name, each) for each in _list(name, "a str or a list of them", value))
    if choices and not choices[0].isdigit():
        return _word(name, value)
    return _number_text(name, value)


def _all_typed(given, rows, typed=_typed):
    """The keywords that were given, by key. TypeError for one that no row has."""
    by_name = {_name(row["key"]): row for row in rows}
    for name in given:
        if name not in by_name:
            near = _difflib.get_close_matches(name, by_name, 1)
            raise TypeError(f"there is no keyword {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))
    return {by_name[name]["key"]: typed(name, value, by_name[name]) for name, value in given.items() if value is not None}


def _all_numbers(given, rows):
    return _all_typed(given, rows, lambda name, value, row: _number(name, value))


def _help(row):
    """One line of a docstring: the keyword, its help and its limits."""
    if row.get("choices"):
        values = ("any of " if row.get("several") else "") + "|".join(row["choices"])
    elif "minimum" in row:
        unit = row.get("unit", "")
        values = (unit + ", " if unit else "") + f"{row['minimum']:g} to {row['maximum']:g}" + (" or auto" if row.get("automatic") else "")
    else:
        values = ""
    if "default" in row:
        values += ("; " if values else "") + f"default {row['default']}"
    return f"    {_name(row['key'])}: {row.get('help', '')}" + (f" [{values}]" if values else "")


def _keywords(*tables):
    """Gives a function's signature and docstring the rows of these tables."""

    def add(function):
        shown = [p for p in _inspect.signature(function).parameters.values() if p.kind is not p.VAR_KEYWORD]
        for title, rows in tables:
            shown += [_inspect.Parameter(_name(row["key"]), _inspect.Parameter.KEYWORD_ONLY, default=None) for row in rows]
            function.__doc__ += f"\n    {title}\n\n" + "\n".join(_help(row) for row in rows) + "\n"
        function.__signature__ = _inspect.Signature(shown)
        return function

    return add


_READING = _edgescan.reading_options()
_PARAMETERS = _edgescan.parameters()
_CHOICES = [dict(row, kind="switch") for row in _edgescan.writing_choices()]
_SWITCHES = [{"key": key, "kind": "switch"} for key in ("ascii", "include-attached", "footprint", "mixed-pixels", "echo-loss", "after-blast", "truth")]
_ROCKS = _edgescan.rock_parameters()
_NUMBERS = [dict(row, default=f"{row['default']:g}") for row in _edgescan.simulation_numbers()]


@_keywords(("Reading, as the flags of the command line:", _READING))
def open(path, **reading):
    """Opens any readable file as a Scan. Its content decides what it is.

    >>> scan = edgescan.open(path)
    >>> scan.range_mm.shape == scan.state.shape == (scan.lines, scan.beams)
    True
    """
    return _edgescan.open(_path("path", path), _all_typed(reading, _READING))


@_keywords(("Parameters, as the sliders of the viewer and the flags of the command line:", _PARAMETERS))
def detect(scan, *, preset=None, **parameters):
    """Finds the edges of a Scan; the same mask bit by bit as `edgescan-cli detect`. Returns a Result.

    preset: name of a built-in preset, or a preset file; the parameters that are given come on top of it.

    Other Python threads run meanwhile. OpenCV's thread pool is off in this process from the first call on.

    >>> result = edgescan.detect(scan, method="canny", lower=10)
    >>> bool(((result.strength >= 10) == (result.mask > 0)).all())
    True
    """
    return _edgescan.detect(scan, _all_typed(parameters, _PARAMETERS), b"" if preset is None else _path("preset", preset))


@_keywords(("Parameters of rocks:", _ROCKS))
def rocks(result, *, region=None, **parameters):
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
        cells = [_list("region", "a list of cells", cell) for cell in _list("region", "a str or a list of cells", region)]
        region = " ".join(f"{_whole('region', line)},{_whole('region', beam)}" for line, beam in cells)
    return _edgescan.rocks(result, _all_numbers(parameters, _ROCKS), region or "")


@_keywords(("Choices of single formats, True or False:", _CHOICES))
def save(what, path, content=None, *, frame="auto", ascii=False, include_attached=False, operator="", role="", **choices):
    """Writes a Scan or a Result, with its record inside and beside it; what was there before stays if that fails.

    content: of a Result 'edges' (the edge points), 'cloud' (all points), 'mask', 'gray', 'range' (PNG) or 'scan' (every cell with its
    state); a Scan is always written whole. Without it .png is the mask, all else the edge points. The extension chooses the format.
    frame: 'mine', 'local', 'scanner' or 'auto' (the usual one). ascii: PCD and PLY as text. include_attached: of a cloud that was
    projected also the points behind the nearest of their cell. operator, role: who exports, for the record.

    Returns the number of points or cells written. The file that the scan was opened from is never written over.

    >>> edgescan.save(result, folder / "edges.pcd") == len(result.edges)
    True
    """
    path = _path("path", path)
    typed = _all_typed(choices, _CHOICES)
    typed.update(_all_typed({"ascii": ascii, "include_attached": include_attached}, _SWITCHES))
    typed.update(frame=_word("frame", frame), operator=_word("operator", operator), role=_word("role", role))
    if content is not None:
        _word("content", content)
    if isinstance(what, Scan):
        if content not in (None, "scan"):
            raise TypeError("a Scan is written whole; detect() first for anything else")
        return _edgescan.save_scan(what, path, typed)
    return _edgescan.save_result(what, path, content or ("mask" if path.lower().endswith(b".png") else "edges"), typed)


def replay(path, *, every=1, speed=0, pose="", calibration=""):
    """Plays a recording through the path that live telegrams take: an iterator of Sweep.

    A Sweep comes behind every `every` lines, and each sweep once more when it is finished. speed: 1 = as it was recorded, 0 = as fast as
    it goes. pose, calibration: files that give the scan its place; the recording may hold its own.

    >>> for sweep in edgescan.replay(recording, every=50):
    ...     edges = edgescan.detect(sweep.scan).mask
    >>> sweep.finished, sweep.complete
    (True, True)
    """
    return _edgescan.replay(_path("path", path), _whole("every", every), _number("speed", speed), _path("pose", pose),
                            _path("calibration", calibration))


def connect(address, *, record="", expected_lines=0, axis=None, first_line=None, line_step=None, ticks_per_degree=None, calibration="",
            standing=False, timeout=30):
    """Connects to an LMS5xx: an iterator of Sweep, the newest state whenever a line came, and each sweep once more when it is finished.

    address: HOST or HOST:PORT. Nothing but reads and a subscription is sent to it. record: new recording (.mcap) of every telegram.
    expected_lines: of a whole sweep, 0 = not known. axis: mounting of the stepper, 'spin' or 'sweep'. first_line, line_step: stepper angles,
    degrees. ticks_per_degree: encoder counts, where there is an encoder. calibration: the robot's file, which says axis and step. What neither
    says is assumed, and the scan's warnings and the recording tell so. standing: the stepper stands while a line is measured.

    timeout: seconds. connect() waits for the first scan line of the scanner, and raises edgescan.Error if it does not come in this time. So
    does the iterator if the sweep does not change for this time. None: connect() returns at once, and the iterator waits without end.

    The session ends with stop(), or at the end of a with block. A lost connection is made again by itself.

    >>> with edgescan.connect(address, expected_lines=40) as scanner:
    ...     for sweep in scanner:
    ...         if sweep.finished:
    ...             break
    >>> sweep.scan.lines
    40
    """
    def number(name, value):
        return None if value is None else _number(name, value)

    return _edgescan.connect(_word("address", address), _path("record", record), _whole("expected_lines", expected_lines),
                             None if axis is None else _word("axis", axis), number("first_line", first_line), number("line_step", line_step),
                             number("ticks_per_degree", ticks_per_degree), _path("calibration", calibration), _switch("standing", standing),
                             number("timeout", timeout))


@_keywords(("Numbers, as the flags of the command line:", _NUMBERS))
def simulate(*, seed=1, scene="hangup", axis="sweep", profile="high", hole=None, surface=None, footprint=True, mixed_pixels=True,
             echo_loss=True, after_blast=False, truth=False, **numbers):
    """A synthetic draw-bell sweep of an LMS511: a Simulation with scan and, where asked for, truth. Same seed, same bytes.

    scene: hangup, pile, empty, wall, staircase or rescan. axis: mounting of the stepper, 'sweep' or 'spin'. profile: beam divergence 'high'
    (resolution, 4.6 mrad) or 'standard' (11 mrad). hole: 'none', 'round' or 'square' holes in the wall. surface: Scan of a surface seen from
    above, for the scene rescan. footprint, mixed_pixels, echo_loss: False switches that part of the measurement off. after_blast:
    the hang-up with some rocks gone and others fallen.

    >>> edgescan.simulate(seed=3, lines=90, beams=96).scan.range_mm.shape
    (90, 96)
    """
    words = {"scene": _word("scene", scene), "axis": _word("axis", axis), "profile": _word("profile", profile)}
    words.update(_all_typed({"footprint": footprint, "mixed_pixels": mixed_pixels, "echo_loss": echo_loss, "after_blast": after_blast,
                             "truth": truth}, _SWITCHES))
    if hole is not None:
        words["hole"] = _word("hole", hole)
    return _edgescan.simulate(_whole("seed", seed), _all_numbers(numbers, _NUMBERS), words, surface)


def __getattr__(name):
    if name == "evaluate":
        raise AttributeError("edgescan.evaluate: scores are in another program now; use edgescan-lab evaluate MASK.png --truth FOLDER --json -")
    raise AttributeError(f"module 'edgescan' has no attribute {name!r}")
