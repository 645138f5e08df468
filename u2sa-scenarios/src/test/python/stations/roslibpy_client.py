"""roslibpy at a rover: subscribes, publishes, calls services; without a log-in it only listens.

    python3 roslibpy_client.py PORT TOKEN     rosbridge's port and the account's token of the broker
"""
import base64
import collections
import math
import os
import sys
import time

import roslibpy

PATIENCE_S = 120.0
BEGAN = time.monotonic()


def say(*words):
    print("%6.1f" % (time.monotonic() - BEGAN), *words, flush=True)


def require(condition, why):
    if not condition:
        say("FAILED:", why)
        os._exit(1)  # roslibpy's reactor would keep the process


def until(what, holds):
    end = time.monotonic() + PATIENCE_S
    while not holds():
        require(time.monotonic() < end, what)
        time.sleep(0.1)
    say(what)


def refused(what, call, *arguments):
    try:
        call(*arguments)
    except Exception as refusal:  # roslibpy has several
        say(what, "refused:", str(refusal)[:160])
        return
    require(False, what + " was accepted")


def connect(token=None):
    headers = None
    if token:
        headers = {"Authorization": "Basic " + base64.b64encode(("local:" + token).encode()).decode()}
    ros = roslibpy.Ros("127.0.0.1", int(sys.argv[1]), headers=headers)
    ros.run(timeout=PATIENCE_S)
    return ros


def speed(odometry):
    linear = odometry["twist"]["twist"]["linear"]
    return math.hypot(linear["x"], linear["y"])


def main():
    listener, operator = connect(), connect(sys.argv[2])
    topics = listener.get_topics()
    topics = topics["topics"] if isinstance(topics, dict) else topics
    require({"/odom", "/fix", "/imu", "/tf"} <= set(topics), "topics: %s" % topics)
    require(listener.get_topic_type("/odom").startswith("nav_msgs/"), "type of /odom")
    require(any("PathPlanner" in each for each in listener.get_nodes()), "nodes")

    counts, last = collections.Counter(), {}

    def heard(name):
        def take(message):
            counts[name] += 1
            last[name] = message
        return take

    for name, kind in (("/odom", "nav_msgs/Odometry"), ("/fix", "sensor_msgs/NavSatFix"), ("/tf", "tf2_msgs/msg/TFMessage"), ("/u2sa/operator", "")):
        roslibpy.Topic(listener, name, kind).subscribe(heard(name))
    until("subscribed", lambda: counts["/odom"] > 20 and counts["/fix"] > 2 and counts["/tf"] > 20)
    until("moves", lambda: speed(last["/odom"]) > 0.3)

    heartbeat = roslibpy.Topic(operator, "/u2sa/operator", "u2sa_msgs/OperatorHeartbeat")
    heartbeat.advertise()
    heartbeat.publish({"operator": "ros"})
    until("published", lambda: counts["/u2sa/operator"] > 0)

    name = "/PathPlanner/LOOK_AHEAD"
    before = listener.get_param(name)
    operator.set_param(name, before * 2)
    require(listener.get_param(name) == before * 2, "the parameter is set")
    refused("a wrong value", operator.set_param, name, -3)
    refused("a listener's order", listener.set_param, name, before)
    operator.set_param(name, before)
    say("services")

    stop = roslibpy.Topic(operator, "/u2sa/emergency_stop", "u2sa_msgs/EmergencyStop")
    stop.advertise()
    stop.publish({"active": True, "operator": "ros", "reason": "test"})
    until("stopped", lambda: speed(last["/odom"]) < 0.05)
    say("done")
    os._exit(0)  # roslibpy's reactor would keep the process


main()
