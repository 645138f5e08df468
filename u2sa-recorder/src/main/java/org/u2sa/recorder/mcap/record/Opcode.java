package org.u2sa.recorder.mcap.record;

/** Record types. Source: mcap.dev/spec. */
public final class Opcode {
  public static final int HEADER = 0x01;
  public static final int FOOTER = 0x02;
  public static final int SCHEMA = 0x03;
  public static final int CHANNEL = 0x04;
  public static final int MESSAGE = 0x05;
  public static final int CHUNK = 0x06;
  public static final int MESSAGE_INDEX = 0x07;
  public static final int CHUNK_INDEX = 0x08;
  public static final int ATTACHMENT = 0x09;
  public static final int ATTACHMENT_INDEX = 0x0A;
  public static final int STATISTICS = 0x0B;
  public static final int METADATA = 0x0C;
  public static final int METADATA_INDEX = 0x0D;
  public static final int SUMMARY_OFFSET = 0x0E;
  public static final int DATA_END = 0x0F;

  /** Bytes before a record's content: opcode and length. */
  public static final int PREFIX = 1 + Long.BYTES;

  private Opcode() {}

  /** Magic bytes at the start and end of a file. */
  public static byte[] magic() {
    return new byte[] {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
  }
}
