package org.u2sa.recorder.mcap;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Schemas and channels of a damaged file, from several places, the most reliable one first. */
final class Definitions {
  /** Where a definition was found. */
  enum Source {
    /** In a summary whose checksum is right. */
    INTACT_SUMMARY,
    /** Among the data: in a chunk whose checksum is right, or outside of chunks. */
    DATA,
    /** In a summary whose checksum is wrong. */
    DAMAGED_SUMMARY,
    /** In a chunk whose checksum is wrong. */
    DAMAGED_CHUNK
  }

  private final Map<Source, Map<Integer, McapSchema>> schemas = new TreeMap<>();
  private final Map<Source, Map<Integer, McapChannel>> channels = new TreeMap<>();

  Definitions() {
    for (Source source : Source.values()) {
      schemas.put(source, new LinkedHashMap<>());
      channels.put(source, new LinkedHashMap<>());
    }
  }

  /**
   * Takes a record; others than schemas and channels are ignored.
   *
   * @throws McapException if it cannot be read
   */
  void take(Source source, int opcode, RecordFields in) throws McapException {
    if (opcode == Opcode.SCHEMA) {
      McapSchema schema = McapSchema.read(in);
      if (schema.id() != 0) {
        schemas.get(source).putIfAbsent(schema.id(), schema);
      }
    } else if (opcode == Opcode.CHANNEL) {
      McapChannel channel = McapChannel.read(in);
      channels.get(source).putIfAbsent(channel.id(), channel);
    }
  }

  /** The schema of that number; null if it was found nowhere. */
  McapSchema schema(int id) {
    return first(schemas.values(), id);
  }

  /** The channel of that number; null if it was found nowhere. */
  McapChannel channel(int id) {
    return first(channels.values(), id);
  }

  private static <T> T first(Collection<Map<Integer, T>> sources, int id) {
    return sources.stream()
        .filter(source -> source.containsKey(id))
        .map(source -> source.get(id))
        .findFirst()
        .orElse(null);
  }

  /** All channels that do not stem from a damaged place alone. */
  List<McapChannel> reliableChannels() {
    Map<Integer, McapChannel> reliable = new LinkedHashMap<>(channels.get(Source.INTACT_SUMMARY));
    channels.get(Source.DATA).forEach(reliable::putIfAbsent);
    return new ArrayList<>(reliable.values());
  }
}
