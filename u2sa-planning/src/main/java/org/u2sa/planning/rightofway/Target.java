package org.u2sa.planning.rightofway;

import org.u2sa.planning.seen.Mover;

/**
 * Another vessel under way, at the time of a decision. Immutable.
 *
 * @param name UID of its track
 * @param northM north coordinate [m]
 * @param eastM east coordinate [m]
 * @param northMps northward velocity over ground [m/s]
 * @param eastMps eastward velocity over ground [m/s]
 * @param radiusM radius around its centre [m]
 * @param sigmaM standard deviation of its position [m]
 * @param sigmaMps standard deviation of its velocity [m/s]
 */
public record Target(
    String name,
    double northM,
    double eastM,
    double northMps,
    double eastMps,
    double radiusM,
    double sigmaM,
    double sigmaMps) {

  /** Converts traffic to a target, extrapolated to a time [µs]. */
  public static Target of(Mover mover, long micros) {
    double age = mover.ageS(micros);
    return new Target(
        mover.name(),
        mover.northAfterM(age),
        mover.eastAfterM(age),
        mover.northMps(),
        mover.eastMps(),
        mover.radiusM(),
        mover.sigmaM() + age * mover.sigmaMps(),
        mover.sigmaMps());
  }

  double speedMps() {
    return Math.hypot(northMps, eastMps);
  }

  double courseRad() {
    return Math.atan2(eastMps, northMps);
  }

  /** Standard deviation of its position after a time [m]. */
  double sigmaAfterM(double seconds) {
    return Math.hypot(sigmaM, sigmaMps * seconds);
  }

  /** The target after a time, on its course. */
  Target after(double seconds) {
    return new Target(
        name,
        northM + northMps * seconds,
        eastM + eastMps * seconds,
        northMps,
        eastMps,
        radiusM,
        sigmaAfterM(seconds),
        sigmaMps);
  }
}
