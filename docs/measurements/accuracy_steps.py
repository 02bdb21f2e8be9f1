"""For docs/measurements/make-accuracy: counts the true edge cells found on each step of a staircase. Independent of the measured program."""
import os
import struct
import zlib

# Heights of the steps, by the objects on both sides (app/lab/sim/simulate.h, kStaircaseMm).
STEPS_MM = {(2, 3): 20, (3, 4): 50, (4, 5): 120, (5, 6): 300, (2, 7): 30, (7, 8): 80, (8, 9): 200, (9, 10): 500}
LEAST_MM = 50  # smaller steps are not scored


def pixels(path):
    """Cells of a gray PNG of 8 or 16 bits, and its width. Python's standard library can inflate, but cannot read pictures."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed, width, height, size = 8, b"", 0, 0, 1
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            width, height, bits = struct.unpack_from(">IIB", data, at + 8)
            size = bits // 8
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, row = zlib.decompress(packed), width * size
    above, cells = bytearray(row), bytearray()
    for line in range(height):
        start = line * (row + 1)
        way, now = raw[start], bytearray(raw[start + 1:start + 1 + row])
        for x in range(row if way else 0):
            left, up, corner = (now[x - size], above[x], above[x - size]) if x >= size else (0, above[x], 0)
            near = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
            paeth = (left, up, corner)[near.index(min(near))]
            now[x] = now[x] + (0, left, up, (left + up) // 2, paeth)[way] & 255
        cells += now
        above = now
    return (struct.unpack(">%dH" % (width * height), cells) if size == 2 else bytes(cells)), width


def step_counts(truth, masks, bands_m):
    """For each step height and band: the number of true edge cells, and the number of those with an edge cell of each mask within 2 cells."""
    (edges, width), (ignored, _), (objects, _), (ranges, _) = [
        pixels(os.path.join(truth, name + ".png")) for name in ("gt_class", "gt_ignore", "object", "range_clean")]
    masks = [pixels(mask)[0] for mask in masks]
    disc = [(i, j) for i in range(-2, 3) for j in range(-2, 3) if i * i + j * j <= 4]
    counts = {}
    for k, edge in enumerate(edges):
        line, beam = divmod(k, width)
        if edge != 1 or ignored[k] or not 2 <= beam < width - 2 or not 2 <= line < len(edges) // width - 2:
            continue
        beyond = [objects[n] for n in (k - 1, k + 1, k - width, k + width)]
        height = max((STEPS_MM.get((objects[k], other), 0) for other in beyond))
        band = sum(ranges[k] >= 1000 * limit for limit in bands_m)
        if height < LEAST_MM or band in (0, len(bands_m)):
            continue
        count = counts.setdefault("%d %d" % (height, band - 1), [0] * (1 + len(masks)))
        count[0] += 1
        for n, mask in enumerate(masks):
            count[1 + n] += any(mask[k + i * width + j] for i, j in disc)
    return counts
