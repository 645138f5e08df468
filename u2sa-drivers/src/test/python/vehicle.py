"""A vehicle played by pymavlink, for org.u2sa.drivers.mavlink's tests.

Usage: vehicle.py tcp|udp. Prints "port N", then each message that it hears as a line of JSON.
Sends its heartbeat by itself, and other messages only once it was asked to by SET_MESSAGE_INTERVAL.
On standard input: "quiet" ends all sending, "speak" begins it again; the end of input ends the vehicle.
"""

import json
import math
import os
import sys
import threading
import time

os.environ["MAVLINK20"] = "1"
from pymavlink import mavutil  # noqa: E402  (reads the environment)

mavlink = mavutil.mavlink
HEARTBEAT_S = 0.5


def port_of(vehicle):
    listening = getattr(vehicle, "listen", None) or vehicle.port
    return listening.getsockname()[1]


class Vehicle:
    def __init__(self, kind):
        self.mav = mavutil.mavlink_connection(
            f"{kind}in:127.0.0.1:0", source_system=7, source_component=1, autoreconnect=True
        )
        self.quiet = False
        self.intervals = {}  # message ID -> seconds
        self.due = {}
        print("port", port_of(self.mav), flush=True)

    def listen_to_test(self):
        for line in sys.stdin:
            self.quiet = line.strip() == "quiet"
        os._exit(0)

    def messages(self):
        m = mavlink
        return {
            m.MAVLINK_MSG_ID_ATTITUDE: lambda: m.MAVLink_attitude_message(
                1000, 0.1, -0.2, -1.5, 0.01, 0.02, 0.03
            ),
            m.MAVLINK_MSG_ID_GLOBAL_POSITION_INT: lambda: m.MAVLink_global_position_int_message(
                1000, 473977420, 85455940, 488100, 10000, 100, 200, 50, 27000
            ),
            m.MAVLINK_MSG_ID_GPS_RAW_INT: lambda: m.MAVLink_gps_raw_int_message(
                0, m.GPS_FIX_TYPE_3D_FIX, 473977420, 85455940, 488100, 90, 120, 224, 6343, 12,
                535000, 800, 1500, 300, 0, 0,
            ),
            m.MAVLINK_MSG_ID_SYS_STATUS: lambda: m.MAVLink_sys_status_message(
                0, 0, 0, 100, 15200, 1230, 64, 0, 0, 0, 0, 0, 0
            ),
        }

    def send_due(self, now):
        if self.quiet:
            return
        if now >= self.due.get("heartbeat", 0.0):
            self.due["heartbeat"] = now + HEARTBEAT_S
            self.mav.mav.heartbeat_send(
                mavlink.MAV_TYPE_GROUND_ROVER,
                mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA,
                mavlink.MAV_MODE_FLAG_SAFETY_ARMED | mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED,
                15,
                mavlink.MAV_STATE_ACTIVE,
            )
        for number, make in self.messages().items():
            if number in self.intervals and now >= self.due.get(number, 0.0):
                self.due[number] = now + self.intervals[number]
                self.mav.mav.send(make())

    def hear(self):
        message = self.mav.recv_match(blocking=True, timeout=0.01)
        while message is not None:
            self.tell(message)
            message = self.mav.recv_match(blocking=False)

    def tell(self, message):
        said = message.to_dict()
        said["from"] = [message.get_srcSystem(), message.get_srcComponent()]
        if message.get_type() == "BAD_DATA":
            said = {"mavpackettype": "BAD_DATA", "reason": message.reason}
        if message.get_type() == "SET_ATTITUDE_TARGET":
            w, x, y, z = message.q
            said["roll"] = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
            said["pitch"] = math.asin(2 * (w * y - z * x))
            said["yaw"] = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
        if message.get_type() == "COMMAND_LONG":
            if message.command == mavlink.MAV_CMD_SET_MESSAGE_INTERVAL:
                self.intervals[int(message.param1)] = message.param2 / 1e6
        print(json.dumps(said), flush=True)

    def run(self):
        threading.Thread(target=self.listen_to_test, daemon=True).start()
        while True:
            self.send_due(time.monotonic())
            self.hear()


if __name__ == "__main__":
    Vehicle(sys.argv[1]).run()
