package org.u2sa.recorder.mcap.record;

import java.util.Map;

/**
 * Named texts about the recording.
 *
 * @param name subject of the texts
 * @param entries texts by name, in the order of writing
 */
public record McapMetadata(String name, Map<String, String> entries) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.METADATA).string(name).map(entries).end();
  }

  public static McapMetadata read(RecordFields in) throws McapException {
    return new McapMetadata(in.string(), in.map());
  }
}
