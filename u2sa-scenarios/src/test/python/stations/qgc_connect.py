"""What QGroundControl asks for when it connects (InitialConnectStateMachine.cc), asked by pymavlink and judged by it.

    python3 qgc_connect.py CONNECTION    such as tcp:127.0.0.1:5760
"""
import json
import logging
import math
import os
import struct
import sys
import tempfile
import time
import zlib

os.environ["MAVLINK20"] = "1"
from pymavlink import mavftp, mavutil  # noqa: E402

COMPONENT_METADATA = 397
AVAILABLE_MODES = 435
PATIENCE_S = 60.0


def fail(why):
    sys.exit("FAILED: " + why)


def require(condition, why):
    if not condition:
        fail(why)


def crc(content):
    """QGC::crc32: begins with 0, is not inverted."""
    return zlib.crc32(content) ^ zlib.crc32(bytes(len(content)))


class Station:
    def __init__(self, address):
        self.link = mavutil.mavlink_connection(address, source_system=255, source_component=190)
        self.mav = self.link.mav
        require(self.link.wait_heartbeat(timeout=PATIENCE_S), "no heartbeat")
        self.beat()

    def beat(self):
        self.mav.heartbeat_send(6, 8, 0, 0, 4)

    def receive(self, kinds, matches=lambda message: True):
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            message = self.link.recv_match(type=kinds, blocking=True, timeout=1.0)
            if message is not None and matches(message):
                return message
        return fail("no %s" % kinds)

    def command(self, number, *parameters):
        parameters = list(parameters) + [0.0] * (7 - len(parameters))
        self.mav.command_long_send(1, 1, number, 0, *parameters)
        return self.receive("COMMAND_ACK", lambda ack: ack.command == number).result

    def unknown(self, number):
        """Content of a message that pymavlink's dialect lacks, zeros restored."""
        message = self.receive("UNKNOWN_%d" % number)
        return bytes(message.get_msgbuf())[10:-2].ljust(255, b"\0")


def identify(station):
    require(station.command(512, 148) == 0, "AUTOPILOT_VERSION refused")
    station.mav.command_long_send(1, 1, 512, 0, AVAILABLE_MODES, 0, 0, 0, 0, 0, 0)
    indices = set()
    count = 1
    while len(indices) < count:
        mode = station.receive("AVAILABLE_MODES")
        count = mode.number_modes
        indices.add(mode.mode_index)
    require(indices == set(range(1, count + 1)), "modes %s of %d" % (indices, count))
    print("modes", count)


def download(files, path):
    with tempfile.TemporaryDirectory() as folder:
        target = os.path.join(folder, "file")
        files.ftp_settings.burst_read_size = 239
        files.cmd_get([path, target])
        answer = files.process_ftp_reply("OpenFileRO", timeout=PATIENCE_S)
        if answer.error_code != 0:
            return answer.error_code
        with open(target, "rb") as content:
            return content.read()


def required(files, path):
    for _ in range(10):  # mavftp gives up after 3.7 s, which a busy machine may need
        content = download(files, path)
        if isinstance(content, bytes):
            return content
    return fail("%s: %s" % (path, content))


def metadata(station, files):
    station.mav.command_long_send(1, 1, 512, 0, COMPONENT_METADATA, 0, 0, 0, 0, 0, 0)
    content = station.unknown(COMPONENT_METADATA)
    _, file_crc = struct.unpack("<II", content[:8])
    uri = content[8:].split(b"\0")[0].decode()
    general = required(files, uri[len("mftp://"):])
    require(crc(general) == file_crc, "general metadata differs from its CRC")
    types = {each["type"]: each for each in json.loads(general)["metadataTypes"]}
    parameters = required(files, types[1]["uri"][len("mftp://"):])
    require(crc(parameters) == types[1]["fileCrc"], "parameter metadata differs from its CRC")
    described = json.loads(parameters)
    require(described["version"] == 1, "QGroundControl reads version 1 only")
    print("metadata of", len(described["parameters"]), "parameters,", len(parameters), "bytes")
    return {each["name"]: each for each in described["parameters"]}


def parameters(station, described):
    station.mav.param_request_list_send(1, 1)
    values = {}
    count = 1
    while len(values) < count:
        value = station.receive("PARAM_VALUE", lambda each: each.param_index != 0xFFFF)
        values[value.param_index] = value
        count = value.param_count
    require(set(values) == set(range(count)), "indices are not dense")
    require({each.param_id for each in values.values()} == set(described), "not all are described")
    hashed = b""
    for value in sorted(values.values(), key=lambda each: each.param_id):
        bits = struct.pack("<f", value.param_value)
        one = described[value.param_id]
        number = value.param_value if one["type"] == "Float" else struct.unpack("<i", bits)[0]
        low, high = one.get("min", -math.inf), one.get("max", math.inf)
        require(low - 1e-3 <= number <= high + 1e-3, "%s = %s is outside its range" % (value.param_id, number))
        if "values" in one:
            require(number in [each["value"] for each in one["values"]], value.param_id + " is none of its values")
        hashed += value.param_id.encode() + raw(value)
    station.mav.param_request_read_send(1, 1, b"_HASH_CHECK", -1)
    check = station.receive("PARAM_VALUE", lambda each: each.param_id == "_HASH_CHECK")
    require(struct.unpack("<I", raw(check))[0] == crc(hashed), "_HASH_CHECK differs")
    print("parameters", count)


def raw(value):
    """The value's bytes as received: a NaN's bits must survive."""
    return bytes(value.get_msgbuf())[10:14].ljust(4, b"\0")


def plans(station):
    for kind, name in enumerate(("mission", "fence", "rally")):
        station.mav.mission_request_list_send(1, 1, kind)
        answer = station.receive(["MISSION_COUNT", "MISSION_ACK"], lambda each: each.mission_type == kind)
        items = getattr(answer, "count", 0)
        for index in range(items):
            station.mav.mission_request_int_send(1, 1, index, kind)
            station.receive("MISSION_ITEM_INT", lambda each: each.seq == index and each.mission_type == kind)
        print(name, answer.get_type(), items)


def buttons(station):
    """Each is answered, whatever the answer."""
    for number in (410, 420, 511, 519, 520, 521, 31, 245, 203, 2500, 200, 42424):
        station.command(number, 0.0)
    print("buttons answered")


def intrusions(files):
    for path in ("/etc/passwd", "/logs/../system.xml"):
        answer = download(files, path)
        require(answer == mavftp.FtpError.FileNotFound, "%s: %s" % (path, answer))
    require(files.cmd_rm(["/general.json"]).error_code == mavftp.FtpError.FileProtected, "a file may be removed")
    print("intrusions refused")


def main():
    logging.disable(logging.WARNING)  # mavftp reports each refusal
    station = Station(sys.argv[1])
    identify(station)
    files = mavftp.MAVFTP(station.link, 1, 1)
    described = metadata(station, files)
    parameters(station, described)
    plans(station)
    buttons(station)
    require(sorted(each.name for each in files.cmd_list(["/"]).directory_listing)[:3] == ["events.json", "general.json", "logs"], "listing")
    intrusions(files)
    recording = required(files, "/logs/recording.mcap")
    require(recording[:8] == b"\x89MCAP0\r\n", "the recording is none")
    print("recording of", len(recording), "bytes")
    print("done")


main()
