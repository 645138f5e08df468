#!/usr/bin/env python3
"""Has Python's own reader (PyPI mcap, mcap-protobuf-support, cbor2) read a recording whole: checksums, every message, every schema.

Usage: check.py FILE…    Exit code 0: all can be read. Prints how many messages of each topic.
"""
import collections
import sys

import cbor2
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

for path in sys.argv[1:]:
    counts = collections.Counter()
    protobuf = DecoderFactory()
    with open(path, "rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        statistics = reader.get_summary().statistics
        for schema, channel, message in reader.iter_messages():
            counts[channel.topic] += 1
            if channel.message_encoding == "cbor":
                cbor2.loads(message.data)
            elif channel.message_encoding == "protobuf":
                protobuf.decoder_for(channel.message_encoding, schema)(message.data)
        attachments = [attachment.name for attachment in reader.iter_attachments()]
        metadata = {record.name: record.metadata for record in reader.iter_metadata()}
    if sum(counts.values()) != statistics.message_count:
        sys.exit(f"{path}: {sum(counts.values())} messages found, but its statistics say {statistics.message_count}")
    print(f"{path}: {statistics.message_count} messages, {statistics.chunk_count} chunks, {len(attachments)} attachments, metadata {sorted(metadata)}")
    for topic in sorted(counts):
        print(f"{counts[topic]:8}  {topic}")
