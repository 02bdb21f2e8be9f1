"""The chain of docs/reference/coordinates.md, written from that page alone: the points of a raw grid in the scanner's frame and in the mine grid."""
import json
import os

import numpy


def about_x(a):
    return numpy.array([[1, 0, 0], [0, numpy.cos(a), -numpy.sin(a)], [0, numpy.sin(a), numpy.cos(a)]])


def about_y(a):
    return numpy.array([[numpy.cos(a), 0, numpy.sin(a)], [0, 1, 0], [-numpy.sin(a), 0, numpy.cos(a)]])


def about_z(a):
    return numpy.array([[numpy.cos(a), -numpy.sin(a), 0], [numpy.sin(a), numpy.cos(a), 0], [0, 0, 1]])


def rpy(roll, pitch, yaw):
    return about_z(yaw) @ about_y(pitch) @ about_x(roll)


def level(pitch, roll):
    return about_y(-pitch) @ about_x(roll)


def turned(axis, angle):
    """Rodrigues' rotation about an axis."""
    x, y, z = numpy.array(axis) / numpy.linalg.norm(axis)
    across = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * across + (1 - numpy.cos(angle)) * across @ across


class Grid:
    """A raw grid: its ranges in metres, lines x beams, 0 where there is no return, and its angles in radians."""

    def __init__(self, path):
        about = json.load(open(path))
        counts = numpy.fromfile(os.path.join(os.path.dirname(path), about["data"]), "<u2").reshape(about["lines"], about["beams"])
        self.ranges = numpy.where(numpy.isin(counts, about["no_return"]), 0, counts * about["unit_mm"] / 1000)
        self.beam_deg, self.line_deg = numpy.array(about["beam_deg"]), numpy.array(about["line_deg"])
        self.cells = numpy.flatnonzero(self.ranges)
        self.axis = {"spin": [0, 0, 1], "sweep": [1, 0, 0]}[about["axis"]]

    def points(self, of_line):
        """The valid cells row by row; of_line: rotation and shift of one line angle, applied to its points in the scanner's frame."""
        beams = numpy.radians(self.beam_deg)
        fan = numpy.stack([numpy.cos(beams), 0 * beams, numpy.sin(beams)], axis=1)
        rows = []
        for ranges, angle in zip(self.ranges, numpy.radians(self.line_deg)):
            rotation, shift = of_line(angle)
            rows.append((fan * ranges[:, None]) @ rotation.T + shift)
        return numpy.concatenate(rows)[self.cells]


def scanner_frame(grid):
    """Step 1 with the ideal mount: the scanner's mirror is the origin."""
    return lambda angle: (turned(grid.axis, angle), numpy.zeros(3))


def mine_frame(pose, robot):
    """Steps 1 to 5 of a static sweep whose boom's azimuth turns about the vertical, as in the examples of the page."""
    radians = lambda group, *names: [numpy.radians(group[n]) for n in names]
    stepper, looks, boom, talin, map_grid = (robot[n] for n in ("stepper", "inclinometer", "boom", "talin", "grid"))
    here, tilt = pose["talin"], pose["inclinometer"]
    mount, mount_shift = rpy(*numpy.radians(stepper["mount_rpy_deg"])), numpy.array(stepper["mount_m"])
    r_ia = {"forward": numpy.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]]), "up": numpy.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])}[looks["viewing"]]
    tx, ty = radians(tilt, "tilt_x_deg", "tilt_y_deg")
    levelled = level(tx, numpy.arcsin(numpy.sin(ty) / numpy.cos(tx)))
    roll, pitch = radians(here, "roll_deg", "pitch_deg")
    heading = numpy.radians(here["heading_deg"] - (map_grid["convergence_deg"] if here["heading_ref"] == "true" else 0))
    r_nv = rpy(roll, pitch, heading)
    r_vr = rpy(*numpy.radians(robot["talin"]["boresight_rpy_deg"])) @ numpy.diag([1, -1, -1])
    up = -(r_nv @ r_vr)[2]
    r_rl = level(numpy.arcsin(up[0]), numpy.arctan2(up[1], up[2])).T @ about_z(numpy.radians(pose["boom"]["azimuth_deg"]))
    head, arm = numpy.array(boom["head_in_robot_m"]), numpy.array(talin["in_robot_m"])
    k = map_grid["scale"]
    to_enu = numpy.array([[0, k, 0], [k, 0, 0], [0, 0, -1]])
    place = numpy.array([here["easting_m"], here["northing_m"], here["elevation_m"]])

    def of_line(angle):
        phi = numpy.radians(stepper["zero_deg"]) + stepper["direction"] * angle
        turn = turned(stepper["axis"], phi)
        to_robot = r_rl @ levelled
        rotation = to_robot @ r_ia @ turn @ mount
        shift = to_robot @ (r_ia @ turn @ mount_shift + numpy.array(looks["offset_m"])) + head
        onward = to_enu @ r_nv @ r_vr
        return onward @ rotation, onward @ (shift - arm) + place
    return of_line
