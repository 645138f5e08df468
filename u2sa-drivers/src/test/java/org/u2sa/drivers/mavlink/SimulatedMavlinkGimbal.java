package org.u2sa.drivers.mavlink;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.u2sa.drivers.link.MemoryLink;

/**
 * A gimbal device of MAVLink, byte for byte, written apart from the driver from the message
 * definitions: it turns at once, and reports its attitude when told to.
 */
final class SimulatedMavlinkGimbal {
  private static final int SET_ATTITUDE = 284;
  private static final int STATUS = 285;
  private static final int STATUS_CRC = 137;

  private final float[] q = {1, 0, 0, 0};
  private int flags;
  private int heartbeats;

  SimulatedMavlinkGimbal(MemoryLink link) {
    link.with(this::accept);
  }

  private void accept(byte[] frame) {
    int id = frame[7] & 0xFF | (frame[8] & 0xFF) << 8;
    if (id == 0) {
      heartbeats++;
      return;
    }
    if (id != SET_ATTITUDE) {
      throw new AssertionError("message " + id);
    }
    byte[] payload = Arrays.copyOf(Arrays.copyOfRange(frame, 10, 10 + (frame[1] & 0xFF)), 32);
    ByteBuffer fields = ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < 4; i++) {
      q[i] = fields.getFloat(4 * i);
    }
    flags = fields.getShort(28);
    if (fields.get(30) != 1 || (fields.get(31) & 0xFF) != 154) {
      throw new AssertionError("for another target");
    }
  }

  /** Flags of the last command. */
  int flags() {
    return flags;
  }

  /** Heartbeats that it has heard. */
  int heartbeats() {
    return heartbeats;
  }

  /** Forward axis of what it carries: forward, right, down of the vehicle. */
  double[] looks() {
    double w = q[0];
    double x = q[1];
    double y = q[2];
    double z = q[3];
    return new double[] {
      1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y),
    };
  }

  /** Its report. */
  byte[] status(int newFlags, int failures) {
    MavlinkFrame frame = new MavlinkFrame(STATUS, STATUS_CRC, 40);
    for (int i = 0; i < 4; i++) {
      frame.f32(4 + 4 * i, q[i]);
    }
    frame.i32(32, failures).i16(36, newFlags);
    return frame.from(1, 154);
  }
}
