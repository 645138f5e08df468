package org.u2sa.recorder.mcap;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordFields;

/**
 * Schemas and channels of a damaged file, collected from several places, preferring the most
 * reliable.
 */
final class Definitions {
  /** Source of a definition. */
  enum Source {
    /** In a summary with a correct checksum. */
    INTACT_SUMMARY,
    /** In the data section: in a chunk with a correct checksum, or outside chunks. */
    DATA,
    /** In a summary with a wrong checksum. */
    DAMAGED_SUMMARY,
    /** In a chunk with a wrong checksum. */
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
   * Adds a record; ignored unless a schema or channel.
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

  /** Schema with this ID; null if not found. */
  McapSchema schema(int id) {
    return first(schemas.values(), id);
  }

  /** Channel with this ID; null if not found. */
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

  /** All channels found in at least one undamaged place. */
  List<McapChannel> reliableChannels() {
    Map<Integer, McapChannel> reliable = new LinkedHashMap<>(channels.get(Source.INTACT_SUMMARY));
    channels.get(Source.DATA).forEach(reliable::putIfAbsent);
    return new ArrayList<>(reliable.values());
  }
}
