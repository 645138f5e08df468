package org.u2sa.drivers.imu;

import java.util.Optional;
import org.u2sa.drivers.compass.Heading;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.nmea.NmeaFramer;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * VectorNav's VN-100 and its kin, as they come from the factory: {@code $VNYMR} 40 times a second
 * at 115200 baud, with yaw, pitch, roll [deg], magnetic field [Gauss], acceleration [m/s²] and
 * angular rate [rad/s] (VN-100 User Manual UM001, asynchronous messages). Yaw is magnetic, unless
 * the unit was told its place.
 */
public final class VectorNav implements ByteParser {
  private static final int YAW = 1;
  private static final int PITCH = 2;
  private static final int ROLL = 3;
  private static final int X_RATE = 10;
  private static final int Y_RATE = 11;
  private static final int Z_RATE = 12;
  private static final double HALF_TURN_DEG = 180.0;
  private static final double TURN_DEG = 360.0;
  private static final double STEEPEST_DEG = 90.0;
  private static final double FASTEST_RAD_PER_S = 40.0; // the sensor ends at 2000 deg/s

  private final NmeaFramer framer = new NmeaFramer();
  private final NmeaFramer.Sink sink = this::take;
  private Optional<Orientation> latest = Optional.empty();
  private long nowMicros;
  private long refused;
  private String lastRefusal = "";

  @Override
  public void accept(byte[] bytes, int length, long now) {
    nowMicros = now;
    framer.accept(bytes, length, sink);
  }

  private void take(NmeaSentence sentence) {
    if (!sentence.isAddressed("VNYMR")) {
      return;
    }
    try {
      double yawDeg = number(sentence, YAW, "yaw", HALF_TURN_DEG);
      latest =
          Optional.of(
              new Orientation(
                  nowMicros,
                  Math.toRadians(number(sentence, ROLL, "roll", HALF_TURN_DEG)),
                  Math.toRadians(number(sentence, PITCH, "pitch", STEEPEST_DEG)),
                  new Heading(
                      nowMicros, Math.toRadians(yawDeg < 0.0 ? yawDeg + TURN_DEG : yawDeg), false),
                  number(sentence, X_RATE, "x rate", FASTEST_RAD_PER_S),
                  number(sentence, Y_RATE, "y rate", FASTEST_RAD_PER_S),
                  number(sentence, Z_RATE, "z rate", FASTEST_RAD_PER_S)));
    } catch (IllegalArgumentException e) { // NumberFormatException is one
      refused++;
      lastRefusal = e.getMessage() + ": " + sentence.text();
    }
  }

  private static double number(NmeaSentence sentence, int field, String what, double most) {
    double value = Double.parseDouble(sentence.field(field));
    if (!(Math.abs(value) <= most)) {
      throw new IllegalArgumentException(what + " " + value + " is outside ±" + most);
    }
    return value;
  }

  /** The newest; empty before the first. A new object for each, the same until the next. */
  public Optional<Orientation> latest() {
    return latest;
  }

  @Override
  public void reset() {
    framer.reset();
  }

  @Override
  public long refused() {
    return framer.refused() + refused;
  }

  @Override
  public String lastRefusal() {
    return lastRefusal.isEmpty() ? framer.lastRefusal() : lastRefusal;
  }
}
