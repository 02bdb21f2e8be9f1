"""The methods of the classes, and what pickle and copy do with a Scan and a Result."""
# mypy: ignore-errors
from __future__ import annotations

import io
import os
from typing import Any, Dict, List, Literal, Optional

import numpy as np
from numpy.typing import NDArray

from . import _edgescan
from ._edgescan import Connection, Replay, Result, Rocks, Scan, Simulation, Sweep
from ._values import Path, method, refuse
from .reports import Detected, Info, Rock


@method(Scan)
def xyz(self, frame: Literal["scanner", "local", "mine"] = "scanner") -> NDArray[np.float64]:
    """float64, lines x beams x 3, m: the point of every cell, NaN where the cell has no range.

    frame: 'scanner', 'local' (east, north, up from `origin`) or 'mine' (Easting, Northing, Elevation).
    """
    return _edgescan.scan_xyz(self, frame)


@method(Scan)
def info(self) -> Info:
    """The JSON of `edgescan-cli info` as a dict."""
    return _edgescan.scan_info(self)


@method(Result)
def report(self) -> Detected:
    """The JSON of `edgescan-cli detect --json` as a dict. edgescan.report() writes the page."""
    return _edgescan.result_report(self)


@method(Result)
def to_dict(self, *, rocks: Optional[Rocks] = None) -> Dict[str, NDArray[Any]]:
    """Every array by its name, those of the scan and xyz too; without those that are None. rocks: a Rocks, whose labels and regions join.

    >>> sorted(result.to_dict())[:3]
    ['beam_deg', 'borders', 'classes']
    """
    if rocks is not None:
        _edgescan.rocks_of_scan(rocks, self)
    sources = [(self.scan, ("range_mm", "state", "intensity", "beam_deg", "line_deg", "line_times_s")),
               (self, ("mask", "classes", "edges", "borders", "strength", "gray")), (rocks, ("labels", "regions"))]
    arrays = {name: getattr(of, name) for of, names in sources if of is not None for name in names}
    arrays["xyz"] = self.scan.xyz()
    return {name: array for name, array in arrays.items() if array is not None}


@method(Result)
def save_npz(self, path: Path, *, rocks: Optional[Rocks] = None) -> int:
    """Writes the arrays of to_dict() for numpy.load(), and returns their number. No record is written with the file.

    >>> result.save_npz(folder / "edges.npz") == len(result.to_dict())
    True
    """
    if not path.endswith(b".npz"):
        refuse("the file is an .npz", os.fsdecode(path), "give a name that ends with .npz")
    arrays = self.to_dict(rocks=rocks)
    content = io.BytesIO()
    np.savez_compressed(content, **arrays)
    _edgescan.write_file(path, content.getvalue())
    return len(arrays)


@method(Rocks)
def at(self, level: float) -> Rocks:
    """The same at another level, without computing the segments again."""
    return _edgescan.rocks_at(self, level)


@method(Rocks)
def table_in(self, frame: Literal["scanner", "local", "mine"]) -> List[Rock]:
    """`table` with the coordinates of this frame.

    frame: 'scanner', 'local' (east, north, up from the scan's `origin`) or 'mine' (Easting, Northing, Elevation).
    """
    return _edgescan.rocks_table(self, frame)


@method(Simulation)
def save_truth(self, folder: Path) -> None:
    """Writes the ground truth as `edgescan-lab simulate --truth FOLDER` does."""
    _edgescan.save_truth(self, folder)


@method(Connection)
def next(self, timeout: Optional[float] = None) -> Sweep:
    """The next change. Error if none comes within `timeout` seconds, by default those of connect(); it says what the session waits for."""
    return _edgescan.connection_next(self, timeout)


@method(Connection)
def stop(self) -> None:
    """Ends the session and closes the recording."""
    _edgescan.connection_stop(self)


def scan_again(content):
    return _edgescan.scan_of_bytes(content)


def result_again(scan, content):
    return _edgescan.result_of_bytes(scan, content)


Scan.__reduce__ = lambda self: (scan_again, (_edgescan.bytes_of_scan(self),))
Result.__reduce__ = lambda self: (result_again, (self.scan, _edgescan.bytes_of_result(self)))


def no_pickle(self):
    kind = type(self).__name__
    raise TypeError(f"a {kind} cannot be pickled; a Scan and a Result can")


for _other in (Connection, Replay, Rocks, Simulation, Sweep):
    _other.__reduce__ = no_pickle
for _unchanging in (Scan, Result):
    _unchanging.__copy__ = lambda self: self
    _unchanging.__deepcopy__ = lambda self, memo: self
