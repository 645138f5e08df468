package org.u2sa.recorder.mcap.record;

/** Position of a metadata record: offset and length of the whole record [B]. */
public record MetadataIndex(long offset, long length, String name) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.METADATA_INDEX).uint64(offset).uint64(length).string(name).end();
  }

  public static MetadataIndex read(RecordFields in) throws McapException {
    return new MetadataIndex(in.uint64(), in.uint64(), in.string());
  }
}
