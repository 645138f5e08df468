"""roslibpy at a rover whose broker has users and TLS: an operator's order counts, an observer's does not.

    python3 roslibpy_secured.py PORT OPERATOR-PASSWORD-FILE OBSERVER-PASSWORD-FILE
"""
import base64
import math
import os
import pathlib
import sys
import time

import roslibpy

PATIENCE_S = 120.0


def require(condition, why):
    if not condition:
        print("FAILED:", why, flush=True)
        os._exit(1)  # roslibpy's reactor would keep the process


def connect(user, file):
    password = pathlib.Path(file).read_text().strip()
    basic = base64.b64encode((user + ":" + password).encode()).decode()
    ros = roslibpy.Ros("localhost", int(sys.argv[1]), is_secure=True, headers={"Authorization": "Basic " + basic})
    ros.run(timeout=PATIENCE_S)
    return ros


def pause(ros, user):
    order = {"requestId": user, "action": "PAUSE", "operator": user}
    roslibpy.Topic(ros, "/u2sa/mission", "u2sa_msgs/MissionOrder").publish(order)


def stands(odometry):
    linear = odometry["twist"]["twist"]["linear"]
    return math.hypot(linear["x"], linear["y"]) < 0.1


def until(what, holds):
    end = time.monotonic() + PATIENCE_S
    while not holds():
        require(time.monotonic() < end, what)
        time.sleep(0.1)
    print(what, flush=True)


def main():
    operator, observer = connect("operator", sys.argv[2]), connect("observer", sys.argv[3])
    heard = []
    roslibpy.Topic(observer, "/odom", "nav_msgs/Odometry").subscribe(heard.append)
    until("the observer sees it drive", lambda: heard and not stands(heard[-1]))
    pause(observer, "observer")
    time.sleep(3.0)
    require(not stands(heard[-1]), "an observer's order counted")
    pause(operator, "operator")
    until("the operator's order stops it", lambda: stands(heard[-1]))
    os._exit(0)


main()
