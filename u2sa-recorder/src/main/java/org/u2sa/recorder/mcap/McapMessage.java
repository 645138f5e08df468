package org.u2sa.recorder.mcap;

/**
 * One message.
 *
 * @param channelId of its channel
 * @param sequence counts the channel's messages, 0…2³²−1
 * @param logTimeNanos when it was recorded [ns]
 * @param publishTimeNanos when it was published [ns]
 * @param data its bytes; not copied, not to be changed
 */
public record McapMessage(
    int channelId, long sequence, long logTimeNanos, long publishTimeNanos, byte[] data) {
  /** Bytes of a message's record beside its data. */
  static final int FIXED = 2 + 4 + 8 + 8;

  void write(RecordBuffer out) {
    out.begin(Opcode.MESSAGE).uint16(channelId).uint32(sequence);
    out.uint64(logTimeNanos).uint64(publishTimeNanos).bytes(data, 0, data.length).endAsIs();
  }

  static McapMessage read(RecordFields in) throws McapException {
    return new McapMessage(
        in.uint16(), in.uint32(), in.uint64(), in.uint64(), in.bytes(in.remaining()));
  }
}
