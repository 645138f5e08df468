package org.u2sa.control.fixedwing;

import java.util.Locale;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Gravity;

/**
 * Speed limits, attitude limits and stall protection of the guidance. Stall speed grows with the
 * square root of the load factor, 1/cos φ in a level turn (14 CFR 23.2110; Cessna 172P handbook,
 * figure 5-3).
 */
record GuidanceVariables(
    @Variable(unit = "m/s", min = 5, max = 100, ifAbsent = 46)
        @Description(
            "Reference calibrated airspeed of the surface gains, which are scaled with speed.")
        double referenceSpeed,
    @Variable(unit = "m/s", min = 6, max = 60, ifAbsent = 40)
        @Description("Calibrated airspeed unless navigation demands a different one.")
        double cruiseSpeed,
    @Variable(unit = "m/s", min = 7, max = 82, ifAbsent = 60)
        @Description("Maximum demanded calibrated airspeed.")
        double maxSpeed,
    @Variable(unit = "m/s", min = 0, max = 30, ifAbsent = 5)
        @Description(
            "Ground speed towards the navigation point below which the airspeed is raised against the wind, up to MAX SPEED; 0: not raised.")
        double minGroundSpeed,
    @Variable(unit = "deg", min = 5, max = 60, ifAbsent = 27.5)
        @Description("Maximum demanded bank.")
        double bankLimit,
    @Variable(unit = "deg/s", min = 2, max = 60, ifAbsent = 15) @Description("Maximum bank rate.")
        double bankRateLimit,
    @Variable(unit = "deg", min = 0, max = 20, ifAbsent = 6.9)
        @Description("Pitch added per load factor above one.")
        double turnPitch,
    @Variable(unit = "deg", min = -30, max = 0, ifAbsent = -10)
        @Description("Minimum demanded pitch.")
        double pitchLowerLimit,
    @Variable(unit = "deg", min = 5, max = 30, ifAbsent = 14)
        @Description("Maximum demanded pitch.")
        double pitchUpperLimit,
    @Variable(unit = "m", min = 5, max = 1000, ifAbsent = 150)
        @Description(
            "Minimum L1 distance: nearer navigation points are treated as this far away, which bounds the gain.")
        double minLookAhead,
    @Variable(unit = "m/s", min = 4, max = 40, ifAbsent = 26.2)
        @Description("Calibrated stall speed, wings level, flaps up.")
        double stallSpeed,
    @Variable(min = 1.05, max = 2, ifAbsent = 1.2)
        @Description("Minimum airspeed over stall speed; bank is limited to keep it in turns.")
        double stallMargin,
    @Variable(unit = "m/s", min = 0.5, max = 15, ifAbsent = 4)
        @Description("Band above the minimum airspeed in which speed gains priority over altitude.")
        double stallBand,
    @Variable(unit = "deg", min = 5, max = 18, ifAbsent = 12)
        @Description("Maximum angle of attack; above it the nose is lowered by the excess.")
        double angleOfAttackLimit,
    @Variable(min = 1.1, max = 3, ifAbsent = 1.7)
        @Description(
            "Maximum load factor at which a descent is arrested that a pilot or another control left.")
        double pullUpLoad,
    @Variable(min = 0, max = 1, ifAbsent = 0.3)
        @Description(
            "Fraction of the wind speed added to the rotation speed and the minimum airspeed, as allowance for gusts near the ground (MIL-F-8785C: σ about 0.2).")
        double gustShare) {
  /** Validates the order of the speeds. */
  GuidanceVariables {
    if (cruiseSpeed > maxSpeed) {
      throw new IllegalArgumentException(
          "CRUISE SPEED " + cruiseSpeed + " m/s is above MAX SPEED " + maxSpeed + " m/s");
    }
    double least = stallSpeed * stallMargin;
    if (least >= cruiseSpeed) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "STALL SPEED times STALL MARGIN is %.1f m/s, expected less than CRUISE SPEED %.1f m/s",
              least,
              cruiseSpeed));
    }
  }

  /** Minimum calibrated airspeed at a bank [m/s]. */
  double leastSpeedMps(double bankRad) {
    double cosine = Math.max(0.1, StrictMath.cos(bankRad));
    return stallMargin * stallSpeed / StrictMath.sqrt(cosine);
  }

  /** Urgency of regaining speed: 0 with margin … 1 at the minimum airspeed. */
  double urgency(FlightState state) {
    double spare = state.calibratedAirspeedMps() - leastSpeedMps(state.rollRad());
    return Limit.within(0.0, 1.0 - spare / stallBand, 1.0);
  }

  /** Maximum bank that keeps the margin at the current airspeed [rad]. */
  double bankLimitRad(FlightState state) {
    double ratio = stallMargin * stallSpeed / Math.max(1.0, state.calibratedAirspeedMps());
    return StrictMath.acos(Math.min(1.0, ratio * ratio));
  }

  /**
   * Vertical acceleration with which a descent may be arrested at the current bank and airspeed
   * [m/s²]; 0 if lift has none to spare. Lift grows with the square of the airspeed, so at the
   * minimum airspeed of level flight the load factor is one.
   */
  double pullUpMps2(FlightState state) {
    double ratio = state.calibratedAirspeedMps() / leastSpeedMps(0.0);
    double load = Math.min(pullUpLoad, ratio * ratio);
    return Gravity.STANDARD_MPS2 * Math.max(0.0, load * StrictMath.cos(state.rollRad()) - 1.0);
  }

  /** Maximum pitch that keeps the angle of attack within its limit [rad]. */
  double pitchLimitRad(FlightState state) {
    return state.pitchRad() + Math.toRadians(angleOfAttackLimit) - state.alphaRad();
  }
}
