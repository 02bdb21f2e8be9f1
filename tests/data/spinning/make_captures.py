"""Captures of a VLP-16 and of an Ouster OS with 16 beams, byte by byte from their public data sheets, with Python's standard library alone.

python3 make_captures.py FOLDER writes vlp16.pcap, vlp16-dual.pcap, os.pcap (fragmented, layout LEGACY) and os-single.pcap (RNG19_RFL8_SIG16_NIR16),
their metadata os.json and os-single.json, and for each the points that the data sheet's equations give: NAME.csv with line, elevation, x, y, z in
the axes of EdgeScan (x forward at azimuth 0, z up) and range in millimetres.
"""
import json
import math
import os
import struct
import sys


def pcap(packets):
    data = struct.pack("<IHHiIII", 0xA1B23C4D, 2, 4, 0, 0, 65535, 1)
    for ns, frame in packets:
        data += struct.pack("<IIII", ns // 10**9, ns % 10**9, len(frame), len(frame)) + frame
    return data


def frames(payload, port, number, longest=65000):
    """Ethernet, IPv4 (in fragments where it is long) and UDP."""
    udp = struct.pack(">HHHH", port, port, 8 + len(payload), 0) + payload
    out, at = [], 0
    while at < len(udp):
        piece = udp[at:at + longest // 8 * 8]
        more = 0x2000 if at + len(piece) < len(udp) else 0
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(piece), number & 0xFFFF, more | at // 8, 64, 17, 0,
                         bytes([192, 168, 1, 201]), bytes([192, 168, 1, 2]))
        out.append(b"\xff" * 6 + b"\x60\x76\x88\0\0\1" + b"\x08\0" + ip + piece)
        at += len(piece)
    return out


def table(path, rows):
    with open(path, "w", encoding="ascii") as file:
        for row in rows:
            file.write(",".join(repr(float(number)) for number in row) + "\n")


START = 1_700_000_000 * 10**9
VLP_ELEVATION = [-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15]  # by laser in the order of firing


def vlp16(folder, name, dual):
    """Turns by 0.4 degrees in a block of 110.592 microseconds."""
    blocks, per_packet = 1344, 6 if dual else 12
    packets, rows = [], []
    for packet in range(blocks // per_packet):
        data = b""
        for n in range(packet * per_packet, (packet + 1) * per_packet):
            for part in range(2 if dual else 1):
                data += b"\xff\xee" + struct.pack("<H", n * 40 % 36000)
                for shot in range(2):
                    for laser in range(16):
                        f = 2 * n + shot
                        count = 0 if (f + laser) % 13 == 0 else 500 + (f * 7 + laser * 31) % 5000
                        other = count + 40 if dual and part == 0 and count else count
                        data += struct.pack("<HB", other, (f + laser) % 256)
                        if part == 0 and n < 900 and count:
                            azimuth = math.radians(n * 0.4 + 0.4 * (shot * 55.296 + laser * 2.304) / 110.592)
                            up, r = math.radians(VLP_ELEVATION[laser]), count * 2 / 1000
                            right, ahead = r * math.cos(up) * math.sin(azimuth), r * math.cos(up) * math.cos(azimuth)
                            rows.append((f, VLP_ELEVATION[laser], ahead, -right, r * math.sin(up), count * 2))
        ns = START + round(packet * per_packet * 110592)
        data += struct.pack("<I", ns // 1000 % 3_600_000_000) + bytes([0x39 if dual else 0x37, 0x22])
        packets += [(ns, frame) for frame in frames(data, 2368, packet)]
    with open(os.path.join(folder, name + ".pcap"), "wb") as file:
        file.write(pcap(packets))
    table(os.path.join(folder, name + ".csv"), rows)


def ouster(folder, name, single):
    width, pixels, bad = 512, 16, 100
    altitude = [16.6 - 33.2 * p / 15 for p in range(pixels)]
    azimuth = [(3.16, 1.05, -1.05, -3.16)[p % 4] for p in range(pixels)]
    packets, rows = [], []
    for packet in range(width * 3 // 2 // 16):
        data = struct.pack("<HH", 1, packet * 16 // width) + bytes(28) if single else b""
        for column in range(packet * 16, packet * 16 + 16):
            m = column % width
            stamp = 5_000_000_000 + column * 195_312
            valid = column != bad
            if single:
                data += struct.pack("<QHH", stamp, m, 1 if valid else 0)
            else:
                data += struct.pack("<QHHI", stamp, m, column // width, m * 90112 // width)
            for p in range(pixels):
                r = 0 if (m + p) % 11 == 0 else 1000 + (m * 3 + p * 17) % 9000
                if single:
                    data += struct.pack("<IBBHHH", r | 0xFFF80000, (m + p) % 256, 0xAA, 300, 20, 0)
                else:
                    data += struct.pack("<IHHHH", r | 0xFFF00000, (m + p) % 256, 300, 20, 0)
                if column < width and valid and r:
                    turn = 2 * math.pi * (1 - m / width) - math.radians(azimuth[p])
                    up, metres = math.radians(altitude[p]), r / 1000
                    rows.append((m, altitude[p], metres * math.cos(turn) * math.cos(up), metres * math.sin(turn) * math.cos(up),
                                 metres * math.sin(up), r))
            if not single:
                data += struct.pack("<I", 0xFFFFFFFF if valid else 0)
        if single:
            data += bytes(32)
        packets += [(START + packet * 16 * 195_312, frame) for frame in frames(data, 7502, packet, 1480)]
    with open(os.path.join(folder, name + ".pcap"), "wb") as file:
        file.write(pcap(packets))
    beams = {"beam_altitude_angles": altitude, "beam_azimuth_angles": azimuth}
    if single:
        sensor = {"sensor_info": {"prod_line": "OS-1-16"}, "beam_intrinsics": beams,
                  "lidar_data_format": {"columns_per_frame": width, "columns_per_packet": 16, "pixels_per_column": pixels}}
    else:
        sensor = dict(beams, prod_line="OS-1-16", lidar_mode=f"{width}x10")
    with open(os.path.join(folder, name + ".json"), "w", encoding="ascii") as file:
        json.dump(sensor, file)
    table(os.path.join(folder, name + ".csv"), rows)


vlp16(sys.argv[1], "vlp16", False)
vlp16(sys.argv[1], "vlp16-dual", True)
ouster(sys.argv[1], "os", False)
ouster(sys.argv[1], "os-single", True)
