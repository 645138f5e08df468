package org.u2sa.drivers.wind;

import java.util.Map;
import java.util.Optional;
import org.u2sa.device.port.Anemometer;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * An NMEA 0183 anemometer, such as Gill WindSonic or Airmar WeatherStation: the relative wind of
 * MWV. Ignores true wind, which the instrument computes from a ship's speed, and readings marked as
 * invalid.
 */
public final class NmeaAnemometer extends ParsedDevice<Anemometer.Wind> implements Anemometer {
  private static final double MAX_MPS = 200.0;
  private static final double FULL_CIRCLE_DEG = 360.0;
  private static final Map<String, Double> MPS_PER_UNIT =
      Map.of("M", 1.0, "N", 1852.0 / 3600.0, "K", 1.0 / 3.6, "S", 1609.344 / 3600.0);

  public NmeaAnemometer(ByteLink link) {
    super(link, new NmeaParser<>(NmeaAnemometer::wind));
  }

  // 1 angle clockwise from the bow [deg], 2 R relative or T true, 3 speed, 4 unit, 5 A valid
  private static Optional<Wind> wind(NmeaSentence sentence, long nowMicros) {
    if (!sentence.is("MWV") || !sentence.field(2).equals("R") || !sentence.field(5).equals("A")) {
      return Optional.empty();
    }
    double degrees = number(sentence.field(1), "angle", FULL_CIRCLE_DEG);
    Double unit = MPS_PER_UNIT.get(sentence.field(4));
    if (unit == null) {
      throw new IllegalArgumentException(
          "unit of speed \"" + sentence.field(4) + "\": expected M, N, K or S");
    }
    double mps = unit * number(sentence.field(3), "speed", MAX_MPS / unit);
    double left = Math.toRadians(-degrees);
    return Optional.of(new Wind(nowMicros, mps, Math.IEEEremainder(left, 2.0 * Math.PI)));
  }

  private static double number(String text, String what, double max) {
    double value = Double.parseDouble(text);
    if (!(value >= 0.0 && value <= max)) {
      throw new IllegalArgumentException(what + " " + text + " is outside 0…" + max);
    }
    return value;
  }

  /** Provider of ANEMOMETER = NMEA. */
  public static final class Provider extends LinkProvider<Anemometer> {
    public Provider() {
      super(Anemometer.class, NmeaAnemometer::new, "NMEA");
    }
  }
}
