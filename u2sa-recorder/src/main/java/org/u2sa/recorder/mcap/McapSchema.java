package org.u2sa.recorder.mcap;

/**
 * What messages of a channel look like.
 *
 * @param id unique in the file, 1…65535
 * @param name of the type
 * @param encoding of the data, such as {@code protobuf}; empty: there is no schema
 * @param data the schema itself; not copied, not to be changed
 */
public record McapSchema(int id, String name, String encoding, byte[] data) {
  void write(RecordBuffer out) {
    out.begin(Opcode.SCHEMA).uint16(id).string(name).string(encoding);
    out.uint32(data.length).bytes(data, 0, data.length).end();
  }

  static McapSchema read(RecordFields in) throws McapException {
    return new McapSchema(in.uint16(), in.string(), in.string(), in.bytes(in.uint32()));
  }
}
