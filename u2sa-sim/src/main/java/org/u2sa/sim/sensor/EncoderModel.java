package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.sim.motion.Arguments;

/** Counts of a wheel encoder: whole ones, and some are missed. */
public final class EncoderModel {
  private static final double TURN_RAD = 2.0 * Math.PI;

  private final double countsPerTurn;
  private final double missed;
  private final Random noise;
  private long passed;
  private long counted;

  /**
   * @param countsPerTurn of the wheel, above 0
   * @param missed share of counts that get lost, 0…1
   * @param name of its random stream
   */
  public EncoderModel(double countsPerTurn, double missed, NoiseStreams streams, String name) {
    Arguments.requirePositive("counts per turn", countsPerTurn);
    Arguments.requireInside("missed counts", missed, 0.0, 1.0);
    this.countsPerTurn = countsPerTurn;
    this.missed = missed;
    this.noise = streams.of(name);
  }

  /**
   * Counts since the start, forward positive.
   *
   * @param angleRad by which the wheel has turned since the start [rad]
   */
  public long sample(double angleRad) {
    long now = (long) StrictMath.floor(angleRad / TURN_RAD * countsPerTurn);
    int step = now > passed ? 1 : -1;
    while (passed != now) {
      passed += step;
      if (missed == 0.0 || noise.nextDouble() >= missed) {
        counted += step;
      }
    }
    return counted;
  }
}
