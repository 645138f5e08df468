package org.u2sa.recorder.mcap.record;

/** Position of an attachment: offset and length of its whole record [B]. */
public record AttachmentIndex(
    long offset,
    long length,
    long logTimeNanos,
    long createTimeNanos,
    long size,
    String name,
    String mediaType) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.ATTACHMENT_INDEX).uint64(offset).uint64(length);
    out.uint64(logTimeNanos).uint64(createTimeNanos).uint64(size).string(name).string(mediaType);
    out.end();
  }

  public static AttachmentIndex read(RecordFields in) throws McapException {
    return new AttachmentIndex(
        in.uint64(), in.uint64(), in.uint64(), in.uint64(), in.uint64(), in.string(), in.string());
  }
}
