package org.u2sa.drivers.motor;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.function.LongSupplier;
import org.u2sa.drivers.link.MemoryLink;

/**
 * A RoboClaw with two motors, byte for byte as its manual says, written apart from the driver: its
 * own CRC by table, its own packet buffer with the pause of 10 ms that empties it, its own serial
 * time-out.
 */
final class SimulatedRoboClaw {
  /** What goes wrong on the way to the host. */
  enum Fault {
    NONE,
    MUTE,
    WRONG_CRC,
    TRUNCATED,
    GARBAGE_BEFORE
  }

  private static final int ADDRESS = 0x80;
  private static final long PACKET_TIMEOUT_MICROS = 10_000;
  private static final double COUNTS_PER_S_AT_FULL_DUTY = 4000.0;
  private static final int[] TABLE = new int[256];

  static {
    for (int i = 0; i < 256; i++) {
      int crc = i << 8;
      for (int bit = 0; bit < 8; bit++) {
        crc = (crc & 0x8000) != 0 ? (crc << 1 ^ 0x1021) & 0xFFFF : crc << 1;
      }
      TABLE[i] = crc;
    }
  }

  private final MemoryLink link;
  private final LongSupplier clock;
  private byte[] buffer = new byte[0];
  private long lastByteMicros;
  private long lastPacketMicros;
  private long movedMicros;
  private final double[] duty = new double[2];
  private final double[] counts = new double[2];
  private int serialTimeout; // tenths of seconds; 0: none
  private int tenthVolts = 124;
  private Fault fault = Fault.NONE;

  SimulatedRoboClaw(MemoryLink link, LongSupplier clock) {
    this.link = link;
    this.clock = clock;
    link.with(this::accept);
  }

  synchronized void fault(Fault newFault) {
    fault = newFault;
  }

  /** Power off and on: it counts from 0 again, and knows no time-out. */
  synchronized void reboot() {
    move();
    Arrays.fill(duty, 0.0);
    Arrays.fill(counts, 0.0);
    serialTimeout = 0;
  }

  /** Lets it begin to count near the wrap of its 32 bits. */
  synchronized void counts(double first, double second) {
    counts[0] = first;
    counts[1] = second;
  }

  /** Duty cycle of motor 0 or 1 now, −1…1. */
  synchronized double duty(int motor) {
    move();
    return duty[motor];
  }

  /** The serial time-out that it was told [0.1 s]. */
  synchronized int serialTimeout() {
    return serialTimeout;
  }

  private void move() {
    long now = clock.getAsLong();
    long endMicros = serialTimeout == 0 ? now : lastPacketMicros + serialTimeout * 100_000L;
    double seconds = Math.max(0, Math.min(now, endMicros) - movedMicros) / 1.0e6;
    for (int motor = 0; motor < 2; motor++) {
      counts[motor] += duty[motor] * COUNTS_PER_S_AT_FULL_DUTY * seconds;
    }
    if (now >= endMicros && serialTimeout != 0) {
      Arrays.fill(duty, 0.0);
    }
    movedMicros = now;
  }

  private synchronized void accept(byte[] bytes) {
    long now = clock.getAsLong();
    if (now - lastByteMicros > PACKET_TIMEOUT_MICROS) {
      buffer = new byte[0];
    }
    lastByteMicros = now;
    for (byte each : bytes) {
      buffer = Arrays.copyOf(buffer, buffer.length + 1);
      buffer[buffer.length - 1] = each;
      if ((buffer[0] & 0xFF) != ADDRESS || buffer.length > 1 && length() < 0) {
        buffer = new byte[0];
      } else if (buffer.length > 1 && buffer.length == length()) {
        byte[] packet = buffer;
        buffer = new byte[0];
        obey(packet, now);
      }
    }
  }

  /** Of a whole packet with this command; −1 for one that is not simulated. */
  private int length() {
    switch (buffer[1]) {
      case 14:
        return 5;
      case 34:
        return 8;
      case 37:
        return 12;
      case 24:
      case 78:
        return 2;
      default:
        return -1;
    }
  }

  private void obey(byte[] packet, long now) {
    if (packet.length > 2 && crc(packet, packet.length) != 0) {
      return; // not acknowledged
    }
    move();
    lastPacketMicros = now;
    switch (packet[1]) {
      case 14:
        serialTimeout = packet[2] & 0xFF;
        say((byte) 0xFF);
        break;
      case 34:
        duty[0] = (short) (packet[2] << 8 | packet[3] & 0xFF) / 32767.0;
        duty[1] = (short) (packet[4] << 8 | packet[5] & 0xFF) / 32767.0;
        say((byte) 0xFF);
        break;
      case 37:
        ByteBuffer speeds = ByteBuffer.wrap(packet, 2, 8);
        duty[0] = speeds.getInt() / COUNTS_PER_S_AT_FULL_DUTY; // its loops are ideal
        duty[1] = speeds.getInt() / COUNTS_PER_S_AT_FULL_DUTY;
        say((byte) 0xFF);
        break;
      case 24:
        answer(packet, (byte) (tenthVolts >> 8), (byte) tenthVolts);
        break;
      default:
        byte[] both = new byte[8];
        for (int i = 0; i < 8; i++) {
          both[i] = (byte) ((long) Math.floor(counts[i / 4]) >> 8 * (3 - i % 4));
        }
        answer(packet, both);
    }
  }

  private void answer(byte[] packet, byte... data) {
    byte[] signed = Arrays.copyOf(packet, 2 + data.length);
    System.arraycopy(data, 0, signed, 2, data.length);
    int crc = crc(signed, signed.length);
    byte[] answer = Arrays.copyOf(data, data.length + 2);
    answer[data.length] = (byte) (crc >> 8);
    answer[data.length + 1] = (byte) crc;
    say(answer);
  }

  private void say(byte... answer) {
    switch (fault) {
      case MUTE:
        return;
      case WRONG_CRC:
        answer[answer.length - 1] ^= 0x10;
        link.fromDevice(answer);
        break;
      case TRUNCATED:
        link.fromDevice(Arrays.copyOf(answer, answer.length - 1));
        break;
      case GARBAGE_BEFORE:
        link.fromDevice((byte) 0xA5, (byte) 0x80);
        link.fromDevice(answer);
        break;
      default:
        link.fromDevice(answer);
    }
  }

  private static int crc(byte[] bytes, int length) {
    int crc = 0;
    for (int i = 0; i < length; i++) {
      crc = crc << 8 & 0xFFFF ^ TABLE[crc >> 8 ^ bytes[i] & 0xFF];
    }
    return crc;
  }
}
