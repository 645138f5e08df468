#!/usr/bin/env python3
"""Looks at what ./u2sa view serves, with PyPI websockets and protobuf: a judge that shares no code with ours.

  pip install websockets protobuf
  scripts/view/check.py ws://localhost:8765 --seconds 5

Subscribes to every channel, decodes every message by its advertised schema, and counts them.
Exit code 1: nothing came, a message could not be decoded, or the server took what a viewer may not do.
"""
import argparse
import asyncio
import base64
import json
import sys
from collections import Counter

import websockets
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory


def decoder(channel):
    """A function that decodes messages of an advertised channel."""
    if channel["encoding"] == "json":
        schema = json.loads(channel["schema"])
        required = schema.get("required", [])

        def decode(payload):
            fields = json.loads(payload)
            missing = [name for name in required if name not in fields]
            unknown = [name for name in fields if name not in schema["properties"]]
            if missing or unknown:
                print(f"note: {channel['topic']}: missing {missing}, not in the schema {unknown}", file=sys.stderr)
            return fields

        return decode
    files = descriptor_pb2.FileDescriptorSet.FromString(base64.b64decode(channel["schema"]))
    pool = descriptor_pool.DescriptorPool()
    for file in files.file:
        pool.Add(file)
    message = message_factory.GetMessageClass(pool.FindMessageTypeByName(channel["schemaName"]))
    return message.FromString


async def look(url, seconds, subprotocol):
    counts, sizes, newest = Counter(), Counter(), {}
    async with websockets.connect(url, subprotocols=[subprotocol], max_size=None) as socket:
        assert socket.subprotocol == subprotocol, socket.subprotocol
        info = json.loads(await socket.recv())
        assert info["op"] == "serverInfo", info
        print(f"{info['name']}, capabilities {info['capabilities']}, {subprotocol}")
        by_subscription = {}
        refused = False
        await socket.send(json.dumps({"op": "advertise", "channels": [{"id": 1, "topic": "x", "encoding": "json", "schemaName": ""}]}))
        end = asyncio.get_running_loop().time() + seconds
        while (left := end - asyncio.get_running_loop().time()) > 0:
            try:
                data = await asyncio.wait_for(socket.recv(), left)
            except asyncio.TimeoutError:
                break
            if isinstance(data, str):
                message = json.loads(data)
                if message["op"] == "advertise":
                    for channel in message["channels"]:
                        by_subscription[channel["id"] + 100] = (channel, decoder(channel))
                    await socket.send(json.dumps({"op": "subscribe", "subscriptions": [
                        {"id": channel["id"] + 100, "channelId": channel["id"]} for channel in message["channels"]]}))
                elif message["op"] == "status":
                    refused |= "read-only" in message["message"]
                    print("status:", message["message"])
            elif data[0] == 1:
                channel, decode = by_subscription[int.from_bytes(data[1:5], "little")]
                newest[channel["topic"]] = decode(data[13:])
                counts[channel["topic"]] += 1
                sizes[channel["topic"]] += len(data)
        for topic in sorted(counts):
            print(f"{counts[topic]:8}  {sizes[topic]:9} B  {topic}")
        return 0 if counts and refused else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("url")
    parser.add_argument("--seconds", type=float, default=5)
    parser.add_argument("--subprotocol", default="foxglove.websocket.v1")
    chosen = parser.parse_args()
    return asyncio.run(look(chosen.url, chosen.seconds, chosen.subprotocol))


if __name__ == "__main__":
    sys.exit(main())
