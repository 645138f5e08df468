package org.u2sa.control.fixedwing;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.handover.HandOver;

/**
 * Height above ground of an aeroplane whose state lacks it: the height above the starting position.
 * The ground is assumed to be level from there to the landing site.
 */
final class GroundReference {
  /** Source of an aeroplane's height. */
  enum Source {
    /** The state; without a height, the aircraft counts as flying high. */
    STATE,
    /** The altitude of the aircraft at rest on the ground. */
    START
  }

  /** Variables of the height above ground. */
  record Variables(
      @Variable(ifAbsentText = "STATE")
          @Description(
              "Source of the height above ground: the STATE, or the altitude at the START, for aircraft without sensors of height and weight on wheels.")
          Source ground,
      @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0)
          @Description(
              "Height of the start above the resting position after landing, e.g. on a catapult or in someone's hand.")
          double startHeight) {}

  private static final double STANDS_MPS = 2.0; // not flying below this ground speed
  private static final double TIME_CONSTANT_S = 5.0;
  private static final double LIFTED_M = 0.5;

  private double groundM = Double.NaN; // altitude of the aircraft at rest on the ground
  private double lastS = Double.NaN;
  private boolean flown;

  /** Learns the ground's altitude while the aircraft waits for its first flight. */
  void see(double timeS, double altitudeM, double groundSpeedMps, double startHeightM) {
    double dtS = Double.isNaN(lastS) ? 0.0 : Math.max(0.0, timeS - lastS);
    lastS = timeS;
    flown |= groundSpeedMps > STANDS_MPS;
    if (flown) {
      return; // unknown if started in flight
    }
    double seenM = altitudeM - startHeightM;
    groundM =
        Double.isNaN(groundM) ? seenM : groundM + dtS / (TIME_CONSTANT_S + dtS) * (seenM - groundM);
  }

  /** Whether the aircraft has begun its first flight, after which the altitude is kept. */
  boolean hasFlown() {
    return flown;
  }

  boolean isKnown() {
    return !Double.isNaN(groundM);
  }

  /** Height above the position at rest [m]. */
  double heightM(double altitudeM) {
    return altitudeM - groundM;
  }

  boolean isOnGround(double altitudeM) {
    return heightM(altitudeM) < LIFTED_M;
  }

  void handOver(HandOver state) {
    state.number("GROUND ALTITUDE", groundM).flag("HAS FLOWN", flown);
  }

  void takeOver(HandOver state) {
    groundM = state.number("GROUND ALTITUDE").orElse(groundM);
    flown = state.number("GROUND ALTITUDE").isPresent() && state.flag("HAS FLOWN");
  }
}
