package org.u2sa.recorder;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionPart;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;

/**
 * Channels and schemas of a recording, numbered in order of first use; each file defines those it
 * uses. Not thread-safe.
 */
final class RecordedChannels {
  private static final int MOST = 0xFFFF; // IDs have 16 bits

  /**
   * Limit for channels of arbitrary sources and types, of which a sender may invent tens of
   * thousands. The rest is reserved for the standard channels.
   */
  private static final int MAX_OF_ANY_NAME = MOST - 4_096;

  private final Map<String, Track> tracks = new HashMap<>();
  private final Map<MessageType<?>, byte[]> texts = new HashMap<>();
  private final Map<String, McapSchema> schemas = new HashMap<>();
  private int file;

  static final class Track {
    private final McapChannel channel;
    private final McapSchema schema;
    private long sequence;
    private int definedIn; // number of the file; 0 if none yet

    private Track(McapChannel channel, McapSchema schema) {
      this.channel = channel;
      this.schema = schema;
    }
  }

  private final Map<Integer, Integer> schemaDefinedIn = new HashMap<>();

  /** Called when a new file is started; it needs all definitions again. */
  void nextFile() {
    file++;
  }

  /** Channel of native messages; its topic is the one used at a broker. */
  Track of(String systemId, Channel<?> channel, U2SAData message) {
    Topic its = Topic.of(systemId, channel, message);
    String topic = its.toString();
    Track known = tracks.get(topic);
    if (known != null) {
      return known;
    }
    List<String> chain = message.typeChain();
    String name = chain.get(chain.size() - 1);
    boolean isStandard =
        its.source().isEmpty()
            && name.equals(message.type().name())
            && Channels.named(channel.name()).isPresent();
    if (!isStandard && tracks.size() >= MAX_OF_ANY_NAME) {
      throw new IllegalStateException(
          "a recording cannot have more than " + MAX_OF_ANY_NAME + " channels of arbitrary names");
    }
    // An unknown type is described as its nearest known ancestor; its bytes hold all fields.
    byte[] text =
        texts.computeIfAbsent(
            message.type(), type -> SchemaText.of(type).getBytes(StandardCharsets.UTF_8));
    return add(topic, "cbor", name, "jsonschema", text, Map.of("channel", channel.name()));
  }

  /** Channel of a topic, whose messages and schema have the same encoding. */
  Track of(String topic, String encoding, String schemaName, byte[] schema) {
    Track known = tracks.get(topic);
    return known == null ? add(topic, encoding, schemaName, encoding, schema, Map.of()) : known;
  }

  private Track add(
      String topic,
      String messageEncoding,
      String schemaName,
      String schemaEncoding,
      byte[] schemaData,
      Map<String, String> metadata) {
    if (tracks.size() >= MOST) {
      throw new IllegalStateException("a recording cannot have more than 65535 channels");
    }
    McapSchema schema =
        schemas.computeIfAbsent(
            schemaEncoding + " " + schemaName,
            key -> new McapSchema(schemas.size() + 1, schemaName, schemaEncoding, schemaData));
    Track track =
        new Track(
            new McapChannel(tracks.size() + 1, schema.id(), topic, messageEncoding, metadata),
            schema);
    tracks.put(topic, track);
    return track;
  }

  /** Writes a message, after its channel's definition if this file lacks it; returns its place. */
  ExecutionPart.Place write(
      McapWriter writer, Track track, long logNanos, long publishNanos, byte[] data)
      throws IOException {
    if (track.definedIn != file) {
      track.definedIn = file;
      if (schemaDefinedIn.getOrDefault(track.schema.id(), 0) != file) {
        schemaDefinedIn.put(track.schema.id(), file);
        writer.add(track.schema);
      }
      writer.add(track.channel);
    }
    long sequence = track.sequence++ & 0xFFFF_FFFFL;
    writer.add(new McapMessage(track.channel.id(), sequence, logNanos, publishNanos, data));
    return new ExecutionPart.Place(track.channel.id(), sequence);
  }
}
