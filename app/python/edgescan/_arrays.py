"""Scan(...): a scan from arrays of numpy."""
# mypy: ignore-errors
from __future__ import annotations

import io
from numbers import Real
from typing import Literal, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _edgescan
from ._edgescan import Scan
from ._values import Path, given, public, refuse, wrong

UNITS_MM = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8, "usft": 1200.0 / 3937.0 * 1000.0}


def numbers(name, value, shape, kinds="iuf", of="Scan()"):
    """The argument as an array of this shape. TypeError if it does not hold numbers, Error if it has another shape."""
    wanted = "whole numbers" if "f" not in kinds else "numbers"
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{of}: {name} must be an array without a mask; use numpy.ma.filled({name}, numpy.nan)")
    try:
        array = np.asarray(value)
    except (TypeError, ValueError):
        raise TypeError(f"{of}: {name} must be an array of {wanted} with lines of equal length, not {given(value)}") from None
    if array.dtype.kind not in kinds:
        raise TypeError(f"{of}: {name} must be an array of {wanted}, not {given(value)} of dtype {array.dtype}")
    if shape is not None and array.shape != shape:
        refuse(f"its shape is {array.shape}", name, f"give the shape {shape}, because range_mm is lines x beams")
    return array


def millimetres(unit):
    """Millimetres per number."""
    if isinstance(unit, str):
        if unit not in UNITS_MM:
            refuse(f'"{unit}" is not a unit', "unit", "use mm, cm, m, in, ft or usft, or the millimetres per number")
        return UNITS_MM[unit]
    if isinstance(unit, bool) or not isinstance(unit, Real):
        raise wrong("Scan(): unit", "'mm', 'cm', 'm' or the millimetres per number", unit)
    mm = float(unit)
    if not 1e-6 <= mm <= 1e6:
        refuse(f"{mm} mm per number is out of reason", "unit", "give 1e-6 to 1e6")
    return mm


def angles(name, value, count):
    if value is None:
        return []
    values = numbers(name, value, (count,)).astype(np.float64)
    bad = np.flatnonzero(~np.isfinite(values))
    if len(bad):
        refuse(f"{values[bad[0]]} is not a number", f"{name}[{bad[0]}]", "give a finite number for each")
    return values.tolist()


def scan(range_mm: ArrayLike, beam_deg: ArrayLike, line_deg: ArrayLike, *, axis: Literal["spin", "sweep"],
         unit: Union[float, Literal["mm", "cm", "m", "in", "ft", "usft"]] = "mm", state: Optional[ArrayLike] = None, intensity: Optional[ArrayLike] = None,
         line_skew_deg: Optional[ArrayLike] = None, line_direction: float = 1.0, line_times_s: Optional[ArrayLike] = None,
         pose: Optional[Path] = None, calibration: Optional[Path] = None, name: str = "array"):
    """A sweep as measured: lines x beams cells, each with a range and a state. edgescan.open() reads one from a file, Scan(...) makes one
    from arrays.

    range_mm: lines x beams, whole numbers or floats. NaN and 0 mean no return; a range below 0 or an infinite one is refused. Ranges are
    stored as float32 in millimetres: whole millimetres up to 16,777 m stay exact.
    beam_deg: beams, the angle of each beam in the fan, degrees. line_deg: lines, the angle of the stepper at each line.
    axis: what the stepper turns about, 'spin' (the viewing direction) or 'sweep' (the 0/180 degree line).
    unit: of range_mm, 'mm', 'cm', 'm', 'in', 'ft', 'usft', or the millimetres per number (0.25 for counts of a quarter).
    state: lines x beams, 0 to 5 as in Scan.state; where it is not 0, range_mm is NaN or 0, or the code of a device status (2).
    intensity: lines x beams, NaN where a cell has none.
    line_skew_deg: beams, degrees that the stepper turned until each beam of a line. line_direction: -1 where line angles turn left-handed.
    line_times_s: lines, ascending seconds since 1970 UTC.
    pose, calibration: files that give the scan its place in the mine, as for open().
    name: for titles.

    >>> import numpy
    >>> ranges = numpy.full((40, 61), 4000.0)
    >>> scan = edgescan.Scan(ranges, numpy.linspace(60, 120, 61), numpy.linspace(0, 20, 40), axis="sweep")
    >>> scan.range_mm.dtype.name, scan.axis, scan.lines, scan.beams
    ('float32', 'sweep', 40, 61)
    >>> bool((edgescan.detect(scan).mask[1:-1, 1:-1] == 0).all())
    True
    """
    if axis not in ("spin", "sweep"):
        refuse(f'"{axis}" is not an axis', "axis", "use spin or sweep")
    if line_direction not in (1.0, -1.0):
        refuse(f"{line_direction} is not a direction", "line_direction", "give 1 or -1")
    if (pose is None) != (calibration is None):
        refuse("a place needs both files, and one was given", "pose, calibration", "give both or neither")
    ranges = numbers("range_mm", range_mm, None)
    if ranges.ndim != 2 or 0 in ranges.shape:
        refuse(f"its shape is {ranges.shape}", "range_mm", "give an array of lines x beams, with one line and one beam at least")
    if state is not None:
        state = numbers("state", state, ranges.shape, "iu")
        bad = np.argwhere((state < 0) | (state > 5))
        if len(bad):
            refuse(f"{state[tuple(bad[0])]} is not a state", f"state{bad[0].tolist()}", "give 0 to 5, as in Scan.state")
        state = np.ascontiguousarray(state, np.uint8)
    if intensity is not None:
        with np.errstate(over="ignore"):
            intensity = np.ascontiguousarray(numbers("intensity", intensity, ranges.shape), np.float32)
        bad = np.argwhere(np.isinf(intensity))
        if len(bad):
            refuse("it is infinite", f"intensity{bad[0].tolist()}", "give a number, or NaN where a cell has none")
    lines, beams = ranges.shape
    for one, value in (("beam_deg", beam_deg), ("line_deg", line_deg)):
        if value is None:
            raise TypeError(f"Scan(): {one} must be an array of numbers, not None")
    return _edgescan.scan_of_arrays({
        "range_mm": np.ascontiguousarray(ranges, np.float64), "counts": ranges.dtype.kind in "iu", "unit_mm": millimetres(unit),
        "state": state, "intensity": intensity, "beam_deg": angles("beam_deg", beam_deg, beams), "line_deg": angles("line_deg", line_deg, lines),
        "line_skew_deg": angles("line_skew_deg", line_skew_deg, beams), "line_times_s": angles("line_times_s", line_times_s, lines),
        "line_direction": line_direction, "axis": axis, "name": name, "pose": pose or b"", "calibration": calibration or b""})


def from_points(xyz: ArrayLike, *, name: str = "points", **reading) -> Scan:
    """A scan from points in memory, as open() reads them from a file.

    xyz: n x 3, or lines x beams x 3 with NaN where a cell has no return. Of n x 3 the grid is found from the order of the points; points
    without an order are projected about the sensor. name: for titles.

    >>> again = edgescan.Scan.from_points(scan.xyz(), unit="m")
    >>> again.range_mm.shape == scan.range_mm.shape
    True
    """
    points = numbers("xyz", xyz, None, of="Scan.from_points()").astype(np.float64)
    if points.size == 0:
        refuse(f"it is empty, of shape {points.shape}", "xyz", "give one point at least")
    if points.ndim not in (2, 3) or points.shape[-1] != 3:
        refuse(f"its shape is {points.shape}", "xyz", "give an array of n x 3 or of lines x beams x 3")
    content = io.BytesIO()
    np.lib.format.write_array(content, np.ascontiguousarray(points), version=(1, 0))
    return _edgescan.scan_of_content(content.getvalue(), ".npy", name, reading)


made = public(scan, "Scan")
Scan.from_points = staticmethod(public(from_points, "Scan.from_points", rows=_edgescan.reading_options()))
