package org.u2sa.recorder.mcap.record;

/**
 * A message.
 *
 * @param channelId ID of its channel
 * @param sequence sequence number in the channel, 0…2³²−1
 * @param logTimeNanos recording time [ns]
 * @param publishTimeNanos publication time [ns]
 * @param data payload; not copied, must not be modified
 */
public record McapMessage(
    int channelId, long sequence, long logTimeNanos, long publishTimeNanos, byte[] data) {
  /** Size of a message record without its payload [B]. */
  public static final int FIXED = 2 + 4 + 8 + 8;

  /** Appends the record, opcode and length included. */
  public void write(RecordBuffer out) {
    out.begin(Opcode.MESSAGE).uint16(channelId).uint32(sequence);
    out.uint64(logTimeNanos).uint64(publishTimeNanos).bytes(data, 0, data.length).endAsIs();
  }

  public static McapMessage read(RecordFields in) throws McapException {
    return new McapMessage(
        in.uint16(), in.uint32(), in.uint64(), in.uint64(), in.bytes(in.remaining()));
  }
}
