package org.u2sa.drivers.sonar;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.payload.HydrophoneArray;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * A hydrophone array whose processor sends an NMEA 0183 sentence for each ping: {@code
 * $YXPNG,frequency [Hz],azimuth clockwise from ahead [deg],elevation up [deg],sigma [deg]*hh};
 * sigma may be empty. Alternatively, arrival times: {@code $YXTOA,frequency [Hz],first hydrophone
 * [µs],second,…*hh}, from any common instant. The sentences are U2SA's own, because there is no
 * common protocol.
 */
public final class NmeaHydrophones extends ParsedDevice<HydrophoneArray.Heard>
    implements HydrophoneArray {
  private static final double MAX_HZ = 1e6;
  private static final double MAX_MICROS = 1e9;
  private static final double FULL_CIRCLE_DEG = 360.0;
  private static final double RIGHT_ANGLE_DEG = 90.0;

  public NmeaHydrophones(ByteLink link) {
    super(link, new NmeaParser<>(NmeaHydrophones::ping));
  }

  private static Optional<Heard> ping(NmeaSentence sentence, long nowMicros) {
    if (sentence.is("TOA")) {
      return Optional.of(arrivals(sentence, nowMicros));
    }
    if (!sentence.is("PNG")) {
      return Optional.empty();
    }
    double hz = number(sentence.field(1), "frequency", 0.0, MAX_HZ);
    double right = number(sentence.field(2), "azimuth", -FULL_CIRCLE_DEG, FULL_CIRCLE_DEG);
    double up = number(sentence.field(3), "elevation", -RIGHT_ANGLE_DEG, RIGHT_ANGLE_DEG);
    String sigma = sentence.field(4);
    return Optional.of(
        new Ping(
            nowMicros,
            hz,
            Math.IEEEremainder(-Math.toRadians(right), 2.0 * Math.PI),
            Math.toRadians(up),
            sigma.isEmpty()
                ? OptionalDouble.empty()
                : OptionalDouble.of(Math.toRadians(number(sigma, "sigma", 0.0, FULL_CIRCLE_DEG)))));
  }

  private static Heard arrivals(NmeaSentence sentence, long nowMicros) {
    List<Double> arrivalsS = new ArrayList<>();
    for (int i = 2; !sentence.field(i).isEmpty(); i++) {
      arrivalsS.add(number(sentence.field(i), "arrival", -MAX_MICROS, MAX_MICROS) / 1e6);
    }
    return new Arrivals(
        nowMicros, number(sentence.field(1), "frequency", 0.0, MAX_HZ), List.copyOf(arrivalsS));
  }

  private static double number(String text, String what, double min, double max) {
    double value = Double.parseDouble(text);
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(what + " " + text + " is outside " + min + "…" + max);
    }
    return value;
  }

  /** Provider of HYDROPHONES = NMEA. */
  public static final class Provider extends LinkProvider<HydrophoneArray> {
    public Provider() {
      super(HydrophoneArray.class, NmeaHydrophones::new, "NMEA");
    }
  }
}
