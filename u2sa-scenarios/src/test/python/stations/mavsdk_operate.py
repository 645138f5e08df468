"""MAVSDK operates a rover: telemetry, parameters, files, metadata, logs, mission, arming, modes.

    python3 mavsdk_operate.py CONNECTION     such as tcpout://127.0.0.1:5760
"""
import json
import math
import os
import sys
import threading
import time

from mavsdk import ComponentType, Configuration, Mavsdk
from mavsdk.plugins.action import Action
from mavsdk.plugins.component_metadata import ComponentMetadata
from mavsdk.plugins.component_metadata.component_metadata import MetadataType
from mavsdk.plugins.events import Events
from mavsdk.plugins.ftp import Ftp
from mavsdk.plugins.log_files import LogFiles
from mavsdk.plugins.mission_raw import MissionRaw
from mavsdk.plugins.mission_raw.mission_raw import MissionItem
from mavsdk.plugins.param import Param
from mavsdk.plugins.telemetry import Telemetry

PATIENCE_S = 120.0
BEGAN = time.monotonic()


def say(*words):
    print("%6.1f" % (time.monotonic() - BEGAN), *words, flush=True)


def require(condition, why):
    if not condition:
        say("FAILED:", why)
        os._exit(1)  # the library's threads would keep the process


def until(what, holds, patience=PATIENCE_S):
    end = time.monotonic() + patience
    while not holds():
        require(time.monotonic() < end, what)
        time.sleep(0.2)
    say(what)


def refused(what, call, *arguments):
    try:
        call(*arguments)
    except Exception as refusal:  # each plugin has its own class
        say(what, "refused:", str(refusal)[:120])
        return
    require(False, what + " was accepted")


def parameters(system):
    param = Param(system)
    everything = param.get_all_params()
    count = len(everything.int_params) + len(everything.float_params)
    require(count > 300, "%d parameters" % count)
    before = param.get_param_float("SAFM_BRAKING")
    param.set_param_float("SAFM_BRAKING", 1.25)
    require(param.get_param_float("SAFM_BRAKING") == 1.25, "the parameter is set")
    refused("a wrong value", param.set_param_float, "SAFM_BRAKING", -1.0)
    require(param.get_param_float("SAFM_BRAKING") == 1.25, "a wrong value changes nothing")
    param.set_param_float("SAFM_BRAKING", before)
    say(count, "parameters, set and refused")
    return count


def metadata(system, count):
    plugin = ComponentMetadata(system)
    done = threading.Event()
    plugin.subscribe_metadata_available(
        lambda update, _: done.set() if update.type == MetadataType.ALL_COMPLETED else None)
    plugin.request_autopilot_component()
    require(done.wait(PATIENCE_S), "metadata")
    described = json.loads(plugin.get_metadata(1, MetadataType.PARAMETER).json_metadata)["parameters"]
    require(len(described) == count, "%d described, %d parameters" % (len(described), count))
    say("metadata of", count, "parameters")


def finished(start, *arguments):
    """Waits for the last result of an operation that reports progress."""
    done = threading.Event()
    results = []

    def progress(result, _data, _user):
        if result.name != "NEXT":
            results.append(result.name)
            done.set()

    start(*arguments, progress)
    require(done.wait(PATIENCE_S), "an answer of " + start.__name__)
    return results[-1]


def files(system):
    ftp = Ftp(system)
    listed = ftp.list_directory("/")
    names = {each.path if hasattr(each, "path") else each.name for each in listed.entries}
    require({"general.json", "parameter.json", "logs"} <= names, "listing: %s" % names)
    os.makedirs("down", exist_ok=True)
    for burst in (False, True):
        require(finished(ftp.download_async, "/parameter.json", "down", burst) == "SUCCESS", "download")
        require(ftp.are_files_identical("down/parameter.json", "/parameter.json"), "checksum")
        os.remove("down/parameter.json")
    require(finished(ftp.download_async, "/etc/passwd", "down", False) != "SUCCESS", "a file of the host")
    refused("removal", ftp.remove_file, "/general.json")
    say("files")


def logs(system):
    plugin = LogFiles(system)
    entries = plugin.get_entries()
    require(len(entries) == 1, "%d logs" % len(entries))
    require(finished(plugin.download_log_file_async, entries[0], "down/log") == "SUCCESS", "log")
    with open("down/log", "rb") as content:
        require(content.read(8) == b"\x89MCAP0\r\n", "the log is a recording")
    say("log of", os.path.getsize("down/log"), "bytes")


def same(one, other):
    fields = ("frame", "command", "autocontinue", "param1", "param2", "param3", "param4", "x", "y", "z")
    pairs = [(getattr(one, each), getattr(other, each)) for each in fields]
    return all(a == b or isinstance(a, float) and math.isnan(a) and math.isnan(b) for a, b in pairs)


def mission(system, telemetry, count):
    raw = MissionRaw(system)
    place = telemetry.position()
    north, east = int(place.latitude_deg * 1e7), int(place.longitude_deg * 1e7)
    items = [
        MissionItem(i, 6, 16, int(i == 0), 1, 0.0, 0.5, 0.0, math.nan, north + 300 * (i % 20) + 300, east + 400 * (i // 20), 0.0, 0)
        for i in range(count)]
    raw.pause_mission()
    began = time.monotonic()
    raw.upload_mission(items)
    uploaded = time.monotonic()
    back = raw.download_mission()
    require(len(back) == count and all(map(same, items, back)), "the mission reads back equal")
    say(count, "items up in %.1f s, down in %.1f s" % (uploaded - began, time.monotonic() - uploaded))
    return raw


def operate(system, telemetry, raw):
    action = Action(system)
    events = []
    Events(system).subscribe_events(lambda event, _: events.append("%s: %s" % (event.event_name, event.message)))
    action.disarm()
    until("disarmed", lambda: not telemetry.armed())
    action.arm()
    until("armed", telemetry.armed)
    raw.start_mission()
    until("mission", lambda: telemetry.flight_mode().name == "MISSION")
    until("second item", lambda: raw.mission_progress().current >= 1)
    action.return_to_launch()
    until("return", lambda: telemetry.flight_mode().name == "RETURN_TO_LAUNCH")
    place = telemetry.position()
    action.goto_location(place.latitude_deg + 5e-5, place.longitude_deg, place.absolute_altitude_m, math.nan)
    action.hold()
    until("hold", lambda: telemetry.flight_mode().name == "HOLD")
    raw.clear_mission()
    require(raw.download_mission() == [], "the mission is cleared")
    refused("take-off", action.takeoff)
    action.terminate()
    refused("arming", action.arm)
    for each in ("disarmed: Disarmed", "armed: Armed", "item_reached: Mission item 0 reached", "arming_refused: Not armed: emergency stop"):
        until("event \"%s\"" % each, lambda: each in events)


def main():
    mavsdk = Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION))
    mavsdk.add_any_connection(sys.argv[1])
    system = mavsdk.first_autopilot(PATIENCE_S)
    require(system is not None, "a connection")
    telemetry = Telemetry(system)
    until("position", lambda: not math.isnan(telemetry.position().latitude_deg))
    metadata(system, parameters(system))
    if "--lossy" not in sys.argv:
        files(system)
        logs(system)
    operate(system, telemetry, mission(system, telemetry, 200))
    say("done")
    os._exit(0)  # the library's threads would keep the process


main()
