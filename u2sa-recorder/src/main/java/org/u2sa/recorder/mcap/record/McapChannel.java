package org.u2sa.recorder.mcap.record;

import java.util.Map;

/**
 * A stream of messages of one topic and encoding.
 *
 * @param id unique in the file, 0…65535
 * @param schemaId ID of its schema; 0 if none
 * @param topic topic name
 * @param messageEncoding such as {@code cbor}
 * @param metadata additional key-value pairs
 */
public record McapChannel(
    int id, int schemaId, String topic, String messageEncoding, Map<String, String> metadata) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.CHANNEL).uint16(id).uint16(schemaId).string(topic).string(messageEncoding);
    out.map(metadata).end();
  }

  public static McapChannel read(RecordFields in) throws McapException {
    return new McapChannel(in.uint16(), in.uint16(), in.string(), in.string(), in.map());
  }
}
