package org.u2sa.estimation;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Rejects values that no sensor of a vehicle on or near the earth can measure. A message may hold
 * any finite double; squared in an estimator, 1e200 overflows to infinity and then yields NaN.
 */
final class Plausibility {
  private static final double MAX_M = 1e8; // from any origin: twice around the earth
  private static final double MAX_MPS = 1e4; // orbital speed is 7.9e3 m/s
  private static final double MAX_MPS2 = 1e4; // a thousand times gravity
  private static final double MAX_RAD = 1e3;
  private static final double MAX_RAD_PER_S = 1e3; // gyroscopes measure up to 70 rad/s
  private static final double MAX_RAD_PER_S2 = 1e5;
  private static final double MAX_LONGITUDE_DEG = 360.0; // some sources use 0…360°
  private static final double MAX_LATITUDE_DEG = 90.0;

  private Plausibility() {}

  /** First implausible value, such as "x 1.0E200, outside ±360.0 deg"; empty if none. */
  static Optional<String> objection(StateInformation sensed) {
    boolean isGlobal = sensed.referenceFrame().equals(ReferenceFrame.GLOBAL);
    for (StateField field : StateField.values()) {
      boolean isDegrees = isGlobal && (field == StateField.X || field == StateField.Y);
      double limit =
          !isDegrees
              ? limit(field.unit())
              : field == StateField.X ? MAX_LONGITUDE_DEG : MAX_LATITUDE_DEG;
      OptionalDouble value = sensed.number(field);
      if (value.isPresent() && Math.abs(value.getAsDouble()) > limit) {
        return Optional.of(text(field.fieldName(), value, limit, isDegrees ? "deg" : field.unit()));
      }
    }
    if (sensed instanceof LandmarkSighting seen) {
      return objection(seen);
    }
    return sensed instanceof InertialMeasurement inertial ? objection(inertial) : Optional.empty();
  }

  private static Optional<String> objection(LandmarkSighting m) {
    OptionalDouble[] metres = {m.range(), m.rangeSigma(), m.landmarkX(), m.landmarkY()};
    for (OptionalDouble each : metres) {
      if (Math.abs(each.orElse(0.0)) > MAX_M) {
        return Optional.of(text("a landmark", each, MAX_M, "m"));
      }
    }
    for (OptionalDouble each : new OptionalDouble[] {m.bearing(), m.bearingSigma()}) {
      if (Math.abs(each.orElse(0.0)) > MAX_RAD) {
        return Optional.of(text("a bearing", each, MAX_RAD, "rad"));
      }
    }
    return Optional.empty();
  }

  private static Optional<String> objection(InertialMeasurement m) {
    OptionalDouble[] rates = {m.rollRate(), m.pitchRate(), m.yawRate(), m.angularRateSigma()};
    for (OptionalDouble rate : rates) {
      if (Math.abs(rate.orElse(0.0)) > MAX_RAD_PER_S) {
        return Optional.of(text("an angular rate", rate, MAX_RAD_PER_S, "rad/s"));
      }
    }
    OptionalDouble[] forces = {
      m.specificForceX(), m.specificForceY(), m.specificForceZ(), m.specificForceSigma()
    };
    for (OptionalDouble force : forces) {
      if (Math.abs(force.orElse(0.0)) > MAX_MPS2) {
        return Optional.of(text("a specific force", force, MAX_MPS2, "m/s2"));
      }
    }
    return Optional.empty();
  }

  private static String text(String name, OptionalDouble value, double limit, String unit) {
    return String.format(
        Locale.ROOT, "%s %.3f, outside ±%s %s", name, value.getAsDouble(), limit, unit);
  }

  private static double limit(String unit) {
    switch (unit) {
      case "m":
        return MAX_M;
      case "m/s":
        return MAX_MPS;
      case "m/s2":
        return MAX_MPS2;
      case "rad":
        return MAX_RAD;
      case "rad/s":
        return MAX_RAD_PER_S;
      case "rad/s2":
        return MAX_RAD_PER_S2;
      default:
        throw new IllegalArgumentException("unit \"" + unit + "\": expected one of a state's");
    }
  }
}
