package org.u2sa.drivers.water;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * A streaming velocity log: Water Linked DVLs, or NMEA 0183 with VBW (speeds over ground and
 * through the water, forward and starboard) or VHW (speed through the water).
 */
public final class SerialVelocityLog extends ParsedDevice<VelocityLog.Speeds>
    implements VelocityLog {
  private static final double MPS_PER_KNOT = 1852.0 / 3600.0;
  private static final double FASTEST_MPS = 60.0;
  private static final OptionalDouble UNKNOWN = OptionalDouble.empty();

  private SerialVelocityLog(ByteLink link, ByteParser<Speeds> parser) {
    super(link, parser);
  }

  /** Creates a Water Linked DVL. Closing the device closes the link. */
  public static SerialVelocityLog waterLinked(ByteLink link) {
    return new SerialVelocityLog(link, new WaterLinkedParser());
  }

  /** Creates an NMEA 0183 log. Closing the device closes the link. */
  public static SerialVelocityLog nmea(ByteLink link) {
    return new SerialVelocityLog(link, new NmeaParser<>(SerialVelocityLog::speeds));
  }

  private static Optional<Speeds> speeds(NmeaSentence sentence, long nowMicros) {
    if (sentence.is("VBW")) { // water: 1 ahead, 2 starboard, 3 status; ground: 4, 5, 6
      boolean isWater = sentence.field(3).equals("A");
      boolean isGround = sentence.field(6).equals("A");
      return Optional.of(
          new Speeds(
              nowMicros,
              isGround ? mps(sentence, 4, 1.0) : UNKNOWN,
              isGround ? mps(sentence, 5, -1.0) : UNKNOWN,
              UNKNOWN,
              isWater ? mps(sentence, 1, 1.0) : UNKNOWN,
              isWater ? mps(sentence, 2, -1.0) : UNKNOWN,
              UNKNOWN));
    }
    if (sentence.is("VHW")) { // field 5: knots through the water
      OptionalDouble ahead = mps(sentence, 5, 1.0);
      return Optional.of(new Speeds(nowMicros, UNKNOWN, UNKNOWN, UNKNOWN, ahead, UNKNOWN, UNKNOWN));
    }
    return Optional.empty();
  }

  private static OptionalDouble mps(NmeaSentence sentence, int field, double sign) {
    String text = sentence.field(field);
    if (text.isEmpty()) {
      return UNKNOWN;
    }
    double value = sign * MPS_PER_KNOT * Double.parseDouble(text);
    if (!(Math.abs(value) <= FASTEST_MPS)) {
      throw new IllegalArgumentException("speed " + text + " kn is outside ±117 kn");
    }
    return OptionalDouble.of(value);
  }

  /** Provider of LOG = WATER LINKED and NMEA. */
  public static final class Provider extends LinkProvider<VelocityLog> {
    public Provider() {
      super(
          VelocityLog.class,
          (name, link) -> name.equals("NMEA") ? nmea(link) : waterLinked(link),
          "WATER LINKED",
          "NMEA");
    }
  }
}
