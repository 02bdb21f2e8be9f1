"""A Foxglove bridge of a robot that turns a laser, with Python's standard library alone: an independent peer for tests of the live bridge.

python3 mock_foxglove_bridge.py PORT [FAULT]

Line i, beam j has the range 1000 + 10 i + j mm, or none where (i + j) % 17 is 0. Everything that a client sends, besides subscriptions, ends the
program with code 3. Faults: "huge" (a frame that says that it has 4 GB), "garbage" (a text that is not JSON), "silent", "http" (no WebSocket).
"""
import base64
import hashlib
import json
import math
import socket
import struct
import sys
import time

LINES, BEAMS = 80, 30
FIRST_BEAM, BEAM_STEP, LINE_STEP = -40.0, 0.5, 0.3
START_NS, PERIOD_NS = 1_700_000_000_250_000_000, 20_000_000

HEADER = "================\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" \
         "================\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"
SCAN = "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\n" \
       "float32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities\n" + HEADER
TRANSFORMS = "geometry_msgs/TransformStamped[] transforms\n================\nMSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\n" \
             "string child_frame_id\nTransform transform\n================\nMSG: geometry_msgs/Transform\nVector3 translation\n" \
             "Quaternion rotation\n================\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n" \
             "================\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n" + HEADER
CHANNELS = [
    {"id": 7, "topic": "/robot/scan", "encoding": "cdr", "schemaName": "sensor_msgs/msg/LaserScan", "schema": SCAN, "schemaEncoding": "ros2msg"},
    {"id": 9, "topic": "/tf", "encoding": "cdr", "schemaName": "tf2_msgs/msg/TFMessage", "schema": TRANSFORMS, "schemaEncoding": "ros2msg"},
    {"id": 11, "topic": "/camera", "encoding": "cdr", "schemaName": "sensor_msgs/msg/Image", "schema": "uint8[] data\n"},
]


class Cdr:
    """Big-endian, which no robot of today sends and every reader must know."""

    def __init__(self):
        self.data = b""

    def put(self, kind, *values):
        size = struct.calcsize(kind)
        for value in values:
            self.data += b"\0" * (-len(self.data) % size) + struct.pack(">" + kind, value)
        return self

    def text(self, text):
        self.put("I", len(text) + 1)
        self.data += text.encode() + b"\0"
        return self

    def header(self, ns, frame):
        return self.put("i", ns // 10**9).put("I", ns % 10**9).text(frame)

    def message(self):
        return b"\0\0\0\0" + self.data


def scan_message(line, ns):
    ranges = [math.inf if (line + beam) % 17 == 0 else (1000 + 10 * line + beam) / 1000 for beam in range(BEAMS)]
    cdr = Cdr().header(ns, "robot/laser")
    cdr.put("f", math.radians(FIRST_BEAM), math.radians(FIRST_BEAM + BEAM_STEP * (BEAMS - 1)), math.radians(BEAM_STEP), 0.0, 0.02, 0.05, 80.0)
    return cdr.put("I", BEAMS).put("f", *ranges).put("I", 0).message()


def transform_message(degrees, ns):
    half = math.radians(degrees) / 2
    cdr = Cdr().put("I", 1).header(ns, "robot/mast").text("robot/laser").put("d", 0.0, 0.0, 0.0)
    return cdr.put("d", math.sin(half), 0.0, 0.0, math.cos(half)).message()


def frame(opcode, payload):
    length = len(payload)
    if length < 126:
        head = struct.pack(">BB", 0x80 | opcode, length)
    elif length < 65536:
        head = struct.pack(">BBH", 0x80 | opcode, 126, length)
    else:
        head = struct.pack(">BBQ", 0x80 | opcode, 127, length)
    return head + payload


def received(connection, count):
    data = b""
    while len(data) < count:
        more = connection.recv(count - len(data))
        if not more:
            raise ConnectionError
        data += more
    return data


def read_frame(connection):
    first, second = received(connection, 2)
    length = second & 127
    if length == 126:
        length = struct.unpack(">H", received(connection, 2))[0]
    elif length == 127:
        length = struct.unpack(">Q", received(connection, 8))[0]
    mask = received(connection, 4) if second & 128 else b"\0\0\0\0"
    data = received(connection, length)
    return first & 15, bytes(byte ^ mask[n % 4] for n, byte in enumerate(data))


def shake_hands(connection):
    request = b""
    while b"\r\n\r\n" not in request:
        request += received(connection, 1)
    fields = dict(line.split(": ", 1) for line in request.decode().split("\r\n")[1:] if ": " in line)
    fields = {name.lower(): value for name, value in fields.items()}
    if "foxglove.websocket.v1" not in fields.get("sec-websocket-protocol", ""):
        sys.exit(4)
    key = fields["sec-websocket-key"] + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
    accept = base64.b64encode(hashlib.sha1(key.encode()).digest()).decode()
    connection.sendall(("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                        f"Sec-WebSocket-Accept: {accept}\r\nSec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n").encode())


def subscriptions_of(connection):
    wanted = {}
    while len(wanted) < 2:
        opcode, data = read_frame(connection)
        if opcode == 8:
            raise ConnectionError
        if opcode != 1:
            sys.exit(3)
        said = json.loads(data)
        if said["op"] != "subscribe":
            sys.exit(3)
        for subscription in said["subscriptions"]:
            if subscription["channelId"] not in (7, 9):
                sys.exit(3)
            wanted[subscription["channelId"]] = subscription["id"]
    return wanted


def serve(connection, fault):
    if fault == "http":
        connection.sendall(b"HTTP/1.0 200 OK\r\nContent-Length: 5\r\n\r\nhello")
        return
    shake_hands(connection)
    if fault == "silent":
        time.sleep(600)
    if fault == "huge":
        connection.sendall(struct.pack(">BBQ", 0x82, 127, 2**32) + b"\1" * 100_000)
        time.sleep(600)
    if fault == "garbage":
        connection.sendall(frame(1, b"}{ what is this"))
        time.sleep(600)
    connection.sendall(frame(1, json.dumps({"op": "serverInfo", "name": "mock", "capabilities": ["clientPublish", "services"]}).encode()))
    connection.sendall(frame(1, json.dumps({"op": "somethingNew", "of": [1, 2]}).encode()))
    connection.sendall(frame(1, json.dumps({"op": "advertise", "channels": CHANNELS}).encode()))
    wanted = subscriptions_of(connection)

    def send(channel, ns, message):
        connection.sendall(frame(2, struct.pack("<BIQ", 1, wanted[channel], ns) + message))

    for line in range(LINES + 1):
        ns = START_NS + line * PERIOD_NS
        if line < LINES:
            send(7, ns, scan_message(line, ns))
        for part in (-0.25, 0.25):
            send(9, ns, transform_message((line + part) * LINE_STEP, ns + int(part * PERIOD_NS)))
        time.sleep(0.002)
    time.sleep(600)


def main():
    server = socket.create_server(("127.0.0.1", int(sys.argv[1])), reuse_port=True)
    while True:
        connection, _ = server.accept()
        try:
            serve(connection, sys.argv[2] if len(sys.argv) > 2 else "")
        except (ConnectionError, OSError):
            pass
        connection.close()


main()
