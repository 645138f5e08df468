package org.u2sa.drivers.imu;

import java.util.Optional;
import org.u2sa.device.port.Heading;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.Orientation;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;
import org.u2sa.messages.frame.Point;

/**
 * VectorNav VN-100 and relatives with factory settings: {@code $VNYMR} at 40 Hz and 115200 baud,
 * with yaw, pitch, roll [deg], magnetic field [Gauss], acceleration [m/s²] and angular rate [rad/s]
 * (VN-100 User Manual UM001, asynchronous messages). Yaw is magnetic unless the unit is configured
 * with its position.
 */
public final class VectorNav extends ParsedDevice<Orientation> implements Imu {
  private static final int YAW = 1;
  private static final int PITCH = 2;
  private static final int ROLL = 3;
  private static final int X_FORCE = 7;
  private static final int Y_FORCE = 8;
  private static final int Z_FORCE = 9;
  private static final int X_RATE = 10;
  private static final int Y_RATE = 11;
  private static final int Z_RATE = 12;
  private static final double HALF_TURN_DEG = 180.0;
  private static final double STEEPEST_DEG = 90.0;
  private static final double STRONGEST_MPS2 = 200.0; // sensor range: 16 g
  private static final double FASTEST_RAD_PER_S = 40.0; // sensor range: 2000 deg/s

  public VectorNav(ByteLink link) {
    super(link, parser());
  }

  /** Converts bytes to readings. */
  public static NmeaParser<Orientation> parser() {
    return new NmeaParser<>(VectorNav::orientation);
  }

  private static Optional<Orientation> orientation(NmeaSentence sentence, long nowMicros) {
    if (!sentence.isAddressed("VNYMR")) {
      return Optional.empty();
    }
    double yawDeg = number(sentence, YAW, "yaw", HALF_TURN_DEG);
    return Optional.of(
        new Orientation(
            nowMicros,
            Math.toRadians(number(sentence, ROLL, "roll", HALF_TURN_DEG)),
            Math.toRadians(number(sentence, PITCH, "pitch", STEEPEST_DEG)),
            Heading.ofDegrees(nowMicros, yawDeg, false),
            number(sentence, X_RATE, "x rate", FASTEST_RAD_PER_S),
            number(sentence, Y_RATE, "y rate", FASTEST_RAD_PER_S),
            number(sentence, Z_RATE, "z rate", FASTEST_RAD_PER_S),
            Optional.of(
                Point.of(
                    number(sentence, X_FORCE, "x acceleration", STRONGEST_MPS2),
                    number(sentence, Y_FORCE, "y acceleration", STRONGEST_MPS2),
                    number(sentence, Z_FORCE, "z acceleration", STRONGEST_MPS2)))));
  }

  private static double number(NmeaSentence sentence, int field, String what, double most) {
    double value = Double.parseDouble(sentence.field(field));
    if (!(Math.abs(value) <= most)) {
      throw new IllegalArgumentException(what + " " + value + " is outside ±" + most);
    }
    return value;
  }

  /** Provider of IMU = VECTORNAV. */
  public static final class Provider extends LinkProvider<Imu> {
    public Provider() {
      super(Imu.class, VectorNav::new, "VECTORNAV");
    }
  }
}
