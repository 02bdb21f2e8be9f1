#!/usr/bin/env python3
# Makes tests/unit/scan/georef/frames_cases.json: the frame chain of docs/reference/coordinates.md, computed independently of the program. Each
# rotation uses Rodrigues' formula, each step is written down as points.
#
# usage: frames_cases.py > ../unit/scan/georef/frames_cases.json
import json
import math


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def on(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def transposed(m):
    return [list(row) for row in zip(*m)]


def about(axis, degrees):
    length = math.sqrt(sum(x * x for x in axis))
    n = [x / length for x in axis]
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    cross = [[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]]
    return [[c * (i == j) + (1 - c) * n[i] * n[j] + s * cross[i][j] for j in range(3)] for i in range(3)]


X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]
DOWN = [[1, 0, 0], [0, -1, 0], [0, 0, -1]]  # forward left up to forward right down


def rpy(roll, pitch, yaw):
    return times(about(Z, yaw), times(about(Y, pitch), about(X, roll)))


def worked_out(q):
    turn = math.radians(q["beam_angle_deg"])
    p_S = [q["range_m"] * math.cos(turn), 0.0, q["range_m"] * math.sin(turn)]
    R_MS = rpy(*q["mount_rpy_deg"])
    p_M = plus(on(R_MS, p_S), q["mount_t_m"])
    phi = q["phi0_deg"] + q["dir"] * q["step_index"] * q["deg_per_step"]
    R_AM = about(q["axis"], phi)
    p_A = on(R_AM, p_M)
    p_I = plus(on(q["R_IA"], p_A), q["t_IA_m"])
    # The two elevations of the inclinometer: first of its x axis, then of its y axis.
    pitch = q["tilt_x_deg"]
    roll = math.degrees(math.asin(math.sin(math.radians(q["tilt_y_deg"])) / math.cos(math.radians(pitch))))
    R_LI = times(about(Y, -pitch), about(X, roll))
    p_L = on(R_LI, p_I)
    R_VR = times(rpy(*q["boresight_rpy_deg"]), DOWN)
    heading = q["heading_true_deg"] - q["convergence_deg"]
    R_NV = rpy(q["roll_deg"], q["pitch_deg"], heading)
    R_NR = times(R_NV, R_VR)
    up = [-x for x in R_NR[2]]
    robot_pitch = math.degrees(math.asin(up[0]))
    robot_roll = math.degrees(math.atan2(up[1], up[2]))
    R_RL = times(transposed(times(about(Y, -robot_pitch), about(X, robot_roll))), about(Z, q["boom_azimuth_deg"]))
    p_R0 = on(R_RL, p_L)
    p_R = plus(p_R0, q["head_in_robot_m"])
    p_V = on(R_VR, minus(p_R, q["talin_in_robot_m"]))
    d_NED = on(R_NV, p_V)
    d_ENU = [d_NED[1], d_NED[0], -d_NED[2]]
    scale = q.get("grid_scale", 1.0)
    scaled = [scale * d_ENU[0], scale * d_ENU[1], d_ENU[2]]
    local = plus(minus(q["talin_ENH_m"], q["origin_ENH_m"]), scaled)
    matrices = {"R_MS": R_MS, "R_AM": R_AM, "R_IA": q["R_IA"], "R_LI": R_LI, "R_RL": R_RL, "R_VR": R_VR, "R_NV": R_NV, "R_NR": R_NR}
    scalars = {"phi_deg": phi, "head_pitch_deg": pitch, "head_roll_deg": roll, "robot_pitch_deg": robot_pitch,
               "robot_roll_deg": robot_roll, "heading_grid_deg": heading}
    return {"p_S": p_S, "p_M": p_M, "p_A": p_A, "p_I": p_I, "p_L": p_L, "p_R0": p_R0, "p_R": p_R, "p_V": p_V, "d_NED": d_NED,
            "d_ENU": d_ENU, "local_ENU": local, "world_ENH": plus(q["origin_ENH_m"], local), "matrices": matrices, "scalars": scalars}


FORWARD = [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]
UPWARD = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]  # its underside to the front
MAIN = {"beam_angle_deg": -5 + 400 / 6, "range_m": 12.345, "mount_rpy_deg": [0.2, -0.1, 0.15], "mount_t_m": [0.0015, 0.004, 0.035],
        "axis": [0, 0, 1], "phi0_deg": 0.0, "dir": 1, "step_index": 321, "deg_per_step": 0.18, "R_IA": FORWARD, "t_IA_m": [0, 0, 0],
        "tilt_x_deg": 14.25, "tilt_y_deg": -3.4, "boom_azimuth_deg": 33.5, "head_in_robot_m": [4.2, 1.3, 2.65],
        "boresight_rpy_deg": [0.05, -0.08, 0.12], "talin_in_robot_m": [-0.85, 0.1, 1.15], "heading_true_deg": 217.4,
        "convergence_deg": -0.35, "pitch_deg": 5.75, "roll_deg": -2.1, "talin_ENH_m": [498765.432, 5150123.456, 287.654],
        "origin_ENH_m": [498700, 5150100, 250]}
OTHERS = {
    "sweep, looking up, other way round": {"axis": [1, 0, 0], "R_IA": UPWARD, "dir": -1, "phi0_deg": 12.5, "step_index": 77},
    "axis out of true, lever arm of the inclinometer": {"axis": [0.01, -0.02, 1], "t_IA_m": [0.12, -0.3, 0.05], "mount_rpy_deg": [-1, 2, 0.5]},
    "grid scale, far tilts": {"grid_scale": 0.9996, "tilt_x_deg": -51, "tilt_y_deg": 22, "pitch_deg": -17, "roll_deg": 11},
    "heading through north, boom to the other side": {"heading_true_deg": 359.9, "convergence_deg": 1.8, "boom_azimuth_deg": -140},
}

if __name__ == "__main__":
    cases = [{"name": "main", "inputs": MAIN, "outputs": worked_out(MAIN)}]
    for name, change in OTHERS.items():
        inputs = {**MAIN, **change}
        cases.append({"name": name, "inputs": inputs, "outputs": worked_out(inputs)})
    print('{"cases": [\n' + ",\n".join(json.dumps(case) for case in cases) + "\n]}")
