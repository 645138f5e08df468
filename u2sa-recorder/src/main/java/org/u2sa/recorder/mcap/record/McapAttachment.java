package org.u2sa.recorder.mcap.record;

import java.util.zip.CRC32;

/**
 * A file attached to the recording.
 *
 * @param logTimeNanos recording time [ns]
 * @param createTimeNanos creation time [ns]; 0 if unknown
 * @param name file name, possibly with folders
 * @param mediaType such as {@code text/xml}
 * @param data content; not copied, must not be modified
 */
public record McapAttachment(
    long logTimeNanos, long createTimeNanos, String name, String mediaType, byte[] data) {
  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.ATTACHMENT).uint64(logTimeNanos).uint64(createTimeNanos);
    out.string(name).string(mediaType).uint64(data.length).bytes(data, 0, data.length);
    out.uint32(out.crcOfContent()).end();
  }

  public static McapAttachment read(RecordFields in) throws McapException {
    long logTime = in.uint64();
    long createTime = in.uint64();
    String name = in.string();
    String mediaType = in.string();
    byte[] data = in.bytes(in.uint64());
    CRC32 actual = in.crcSoFar();
    long expected = in.uint32();
    if (expected != 0 && expected != actual.getValue()) {
      throw new McapException("attachment \"" + name + "\" is damaged: its checksum is wrong");
    }
    return new McapAttachment(logTime, createTime, name, mediaType, data);
  }
}
