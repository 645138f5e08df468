package org.u2sa.control.ground;

import java.util.OptionalDouble;
import org.u2sa.control.Transfer;

/**
 * Integral trim of steady speed errors from slopes, soft ground, load or a discharging battery. It
 * is bounded by the motors' capability, is zero while the vehicle stands, so that it never creeps,
 * and resets with each drive, each turn and each change of direction. When the vehicle is to slow
 * down, a trim that drives it on decreases in proportion to the demand: it would otherwise lengthen
 * the braking distance of a loaded vehicle. One that holds it back stays.
 */
final class SpeedTrim {
  private static final String NAME = "SPEED TRIM"; // key in a hand-over

  private double trim;
  private double direction; // 1 forward, -1 in reverse, 0 in a turn in place
  private double demandedMps; // last demand, signed

  void transfer(Transfer state) {
    trim = state.number(NAME, trim);
    direction = state.number(NAME + " DIRECTION", direction);
    demandedMps = state.number(NAME + " DEMAND", demandedMps);
  }

  /** Keeps a fraction of the trim, 0…1. */
  void scale(double fraction) {
    trim *= fraction;
  }

  /**
   * Computes the addition to the demand.
   *
   * @param demanded demand on the motors
   * @param error demanded minus measured quantity; empty if unknown
   * @param atFullPower whether the motors are saturated (anti-windup)
   * @param gain fraction of an error corrected per second [1/s]; 0: no feedback
   * @param most limit of the magnitude of demand plus trim
   */
  double step(
      Drive demanded,
      OptionalDouble error,
      boolean atFullPower,
      double gain,
      double most,
      double stepS) {
    double before = direction;
    direction = Math.signum(demanded.speedMps());
    if (demanded.isStanding() || direction != before || gain == 0.0) {
      trim = 0.0;
    } else if (trim * direction > 0.0) {
      trim *= Math.min(1.0, demanded.speedMps() / demandedMps);
    }
    demandedMps = demanded.speedMps();
    if (!demanded.isStanding() && error.isPresent()) {
      double speed = demanded.speedMps();
      double more = gain * stepS * error.getAsDouble();
      boolean isMore = more * (direction == 0.0 ? trim : direction) > 0.0;
      trim += atFullPower && isMore ? 0.0 : more;
      trim = Math.max(-most - speed, Math.min(most - speed, trim));
    }
    return trim;
  }
}
