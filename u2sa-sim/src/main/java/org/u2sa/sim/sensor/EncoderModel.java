package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.sim.motion.Arguments;

/** Wheel encoder with quantisation and missed counts. */
public final class EncoderModel {
  private static final double TURN_RAD = 2.0 * Math.PI;

  private final double countsPerTurn;
  private final double missed;
  private final Random noise;
  private long passed;
  private long counted;

  /**
   * @param countsPerTurn counts per wheel revolution, above 0
   * @param missed fraction of lost counts, 0…1
   * @param name name of its random stream
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
   * @param angleRad wheel rotation since the start [rad]
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
