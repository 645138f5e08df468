package org.u2sa.sim.payload;

import org.u2sa.sim.motion.Arguments;

/**
 * One joint with limits, a maximum rate and a first-order lag: its rate is the remaining distance
 * divided by the time constant, up to the maximum. Not thread-safe.
 */
final class SimulatedJoint {
  private static final double MICROS_PER_S = 1e6;
  private static final double STEP_S = 1e-3;

  /**
   * Properties of a joint.
   *
   * @param lowestRad lowest angle [rad]
   * @param highestRad highest angle [rad]
   * @param rateRadPerS maximum rate [rad/s]
   * @param lagS time constant [s]
   */
  record Properties(double lowestRad, double highestRad, double rateRadPerS, double lagS) {
    Properties {
      Arguments.requireInside("lowest angle", lowestRad, -2.0 * Math.PI, 2.0 * Math.PI);
      Arguments.requireInside("highest angle", highestRad, lowestRad, 2.0 * Math.PI);
      Arguments.requirePositive("rate", rateRadPerS);
      Arguments.requirePositive("lag", lagS);
    }
  }

  private final Properties properties;
  private double wantedRad;
  private double angleRad;
  private long atMicros = Long.MIN_VALUE;

  SimulatedJoint(Properties properties) {
    this.properties = properties;
    angleRad = bounded(0.0);
    wantedRad = angleRad;
  }

  private double bounded(double angle) {
    return Math.max(properties.lowestRad(), Math.min(properties.highestRad(), angle));
  }

  void turn(double targetRad) {
    wantedRad = bounded(targetRad);
  }

  double angleRad() {
    return angleRad;
  }

  /** Advances to a time of the run's clock. */
  void advance(long nowMicros) {
    atMicros = atMicros == Long.MIN_VALUE ? nowMicros : atMicros;
    double left = (nowMicros - atMicros) / MICROS_PER_S;
    while (left > 0.0 && angleRad != wantedRad) {
      double step = Math.min(left, STEP_S);
      double toGo = wantedRad - angleRad;
      double share = Math.min(1.0, step / properties.lagS());
      double way = Math.min(Math.abs(toGo) * share, properties.rateRadPerS() * step);
      angleRad += Math.copySign(way, toGo);
      left -= step;
    }
    atMicros = Math.max(atMicros, nowMicros);
  }
}
