package org.u2sa.drivers.motor;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.function.LongSupplier;
import org.u2sa.drivers.link.MemoryLink;

/**
 * A VESC with a motor of seven pole pairs, byte for byte, written apart from the driver: CRC by
 * table, its own timeout. At full duty it turns 3000 times a minute.
 */
final class SimulatedVesc {
  private static final long TIMEOUT_MICROS = 1_000_000;
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
  private final ByteArrayOutputStream heard = new ByteArrayOutputStream();
  private double duty;
  private long dutyMicros;
  private int fault;
  private boolean isBlocked;
  private boolean isGarbled;

  SimulatedVesc(MemoryLink link, LongSupplier clock) {
    this.link = link;
    this.clock = clock;
    link.with(this::accept);
  }

  /** Duty cycle that the motor has now, −1…1. */
  synchronized double duty() {
    return clock.getAsLong() - dutyMicros <= TIMEOUT_MICROS ? duty : 0.0;
  }

  synchronized void fault(int code) {
    fault = code;
  }

  synchronized void block() {
    isBlocked = true;
  }

  synchronized void garble(boolean value) {
    isGarbled = value;
  }

  private synchronized void accept(byte[] bytes) {
    heard.writeBytes(bytes);
    byte[] all = heard.toByteArray();
    int at = 0;
    while (all.length - at > 1 && all.length - at >= 5 + all[at + 1]) {
      int end = at + 2 + all[at + 1];
      byte[] payload = Arrays.copyOfRange(all, at + 2, end);
      int crc = (all[end] & 0xFF) << 8 | all[end + 1] & 0xFF;
      if (all[at] != 2 || all[end + 2] != 3 || crc != crc(payload)) {
        throw new AssertionError("not a packet: " + Arrays.toString(all));
      }
      obey(ByteBuffer.wrap(payload));
      at = end + 3;
    }
    heard.reset();
    heard.write(all, at, all.length - at);
  }

  private void obey(ByteBuffer payload) {
    switch (payload.get()) {
      case 5:
        duty = payload.getInt() / 100_000.0;
        dutyMicros = clock.getAsLong();
        break;
      case 4:
        say(values());
        break;
      default:
        throw new AssertionError("unknown command");
    }
  }

  private byte[] values() {
    double turning = isBlocked ? 0.0 : duty();
    ByteBuffer values = ByteBuffer.allocate(74); // firmware 6 appends what the driver does not read
    values.put((byte) 4).putShort((short) 312).putShort((short) 255); // temperatures
    values.putInt((int) (duty() * 2000.0)).putInt((int) Math.abs(duty() * 1500.0)); // currents
    values.putInt(1).putInt(2).putShort((short) (duty() * 1000.0));
    values.putInt((int) (turning * 3000.0 * 7.0)).putShort((short) 160);
    values.putInt(11).putInt(12).putInt(13).putInt(14).putInt(15).putInt(16);
    values.put((byte) fault);
    return values.array();
  }

  private void say(byte[] payload) {
    int crc = crc(payload) ^ (isGarbled ? 1 : 0);
    ByteBuffer packet = ByteBuffer.allocate(payload.length + 5);
    packet.put((byte) 2).put((byte) payload.length).put(payload).putShort((short) crc);
    link.fromDevice(packet.put((byte) 3).array());
  }

  private static int crc(byte[] bytes) {
    int crc = 0;
    for (byte each : bytes) {
      crc = crc << 8 & 0xFFFF ^ TABLE[crc >> 8 ^ each & 0xFF];
    }
    return crc;
  }
}
