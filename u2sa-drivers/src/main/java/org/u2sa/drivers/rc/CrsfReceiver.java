package org.u2sa.drivers.rc;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.drivers.link.BinaryFramer;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;

/**
 * A receiver that sends CRSF frames, such as TBS Crossfire and ExpressLRS (TBS CRSF protocol
 * specification, frame 0x16): {@code C8 length 16 16 × 11 bits CRC}, 420 kBd, 8N1. Other frames are
 * skipped.
 */
public final class CrsfReceiver extends LinkedDevice<RadioReceiver.Pulses>
    implements RadioReceiver {
  private static final int SYNC = 0xC8;
  private static final int CHANNELS_TYPE = 0x16;
  private static final int CHANNELS = 16;
  private static final int BITS = 11;
  private static final int PAYLOAD = CHANNELS * BITS / 8;
  private static final int LONGEST = 64;
  private static final int SHORTEST = 4;
  private static final int POLYNOMIAL = 0xD5; // CRC-8/DVB-S2
  private static final double CENTRE = 992.0; // value range: 172…1811 for 988…2012 µs
  private static final double CENTRE_S = 1500.0e-6;
  private static final double STEP_S = 0.625e-6;

  private final Framer framer = new Framer();
  private long nowMicros;
  private long malformed;
  private String refusal = "";

  public CrsfReceiver(ByteLink link) {
    super(link);
  }

  @Override
  protected void found(long micros) {
    framer.reset();
  }

  @Override
  protected void hear(byte[] bytes, int length, long micros) {
    nowMicros = micros;
    framer.accept(bytes, length);
  }

  @Override
  public long malformed() {
    return malformed;
  }

  @Override
  public String lastRefusal() {
    return refusal;
  }

  static int crc(byte[] bytes, int from, int to) {
    int crc = 0;
    for (int i = from; i < to; i++) {
      crc ^= bytes[i] & 0xFF;
      for (int bit = 0; bit < Byte.SIZE; bit++) {
        crc = (crc & 0x80) != 0 ? (crc << 1 ^ POLYNOMIAL) & 0xFF : crc << 1 & 0xFF;
      }
    }
    return crc;
  }

  private final class Framer extends BinaryFramer {
    Framer() {
      super(
          LONGEST,
          why -> {
            malformed++;
            refusal = why;
          });
    }

    @Override
    protected int lengthAt(int at, int available) {
      if (unsigned8(at) != SYNC) {
        return NONE;
      }
      if (available < 2) {
        return 2;
      }
      int length = unsigned8(at + 1) + 2;
      return length < SHORTEST || length > LONGEST ? NONE : length;
    }

    @Override
    protected String fault(int at, int length) {
      int end = at + length - 1;
      if (crc(bytes(), at + 2, end) != unsigned8(end)) {
        return "CRSF frame with a wrong checksum";
      }
      boolean isShort = unsigned8(at + 2) == CHANNELS_TYPE && length < SHORTEST + PAYLOAD;
      return isShort ? "CRSF channels in " + length + " bytes" : "";
    }

    @Override
    protected void take(int at, int length) {
      if (unsigned8(at + 2) != CHANNELS_TYPE) {
        return;
      }
      List<Double> widths = new ArrayList<>();
      for (int channel = 0; channel < CHANNELS; channel++) {
        int value = 0;
        for (int bit = 0; bit < BITS; bit++) {
          int place = channel * BITS + bit;
          value |= (unsigned8(at + 3 + place / Byte.SIZE) >> place % Byte.SIZE & 1) << bit;
        }
        widths.add(CENTRE_S + (value - CENTRE) * STEP_S);
      }
      latest = Optional.of(new Pulses(nowMicros, widths));
    }
  }

  /** Provider of RADIO = CRSF. */
  public static final class Provider extends LinkProvider<RadioReceiver> {
    public Provider() {
      super(RadioReceiver.class, CrsfReceiver::new, "CRSF");
    }
  }
}
