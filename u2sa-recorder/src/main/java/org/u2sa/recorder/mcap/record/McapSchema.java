package org.u2sa.recorder.mcap.record;

/**
 * Schema of a channel's messages.
 *
 * @param id unique in the file, 1…65535
 * @param name type name
 * @param encoding schema encoding, such as {@code protobuf}; empty if there is no schema
 * @param data the schema itself; not copied, must not be modified
 */
public record McapSchema(int id, String name, String encoding, byte[] data) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.SCHEMA).uint16(id).string(name).string(encoding);
    out.uint32(data.length).bytes(data, 0, data.length).end();
  }

  public static McapSchema read(RecordFields in) throws McapException {
    return new McapSchema(in.uint16(), in.string(), in.string(), in.bytes(in.uint32()));
  }
}
