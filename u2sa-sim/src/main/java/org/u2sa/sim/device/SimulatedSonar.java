package org.u2sa.sim.device;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.u2sa.device.port.Sonar;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/**
 * A mechanically scanned sonar that turns one step after each ping, with faint background noise.
 */
public final class SimulatedSonar extends SimulatedDevice<Sonar.Ping> implements Sonar {
  private static final double FULL_TURN = 2.0 * Math.PI;
  private static final double FULL_SCALE = 255.0;
  private static final double STRENGTH = 200.0;
  private static final double BACKGROUND = 20.0;
  private static final double ECHO_SAMPLES = 2.0; // standard deviation of an echo's length

  private final Head head;
  private final DoubleUnaryOperator distance;
  private final Random noise;
  private long pings;

  /**
   * Scan parameters.
   *
   * @param rateHz pings per second
   * @param stepRad step between pings, left positive [rad]
   * @param samples samples per ping
   * @param reachM range at the end of the last sample [m]
   */
  public record Head(double rateHz, double stepRad, int samples, double reachM) {
    /**
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Head {
      Arguments.requireInside("step", stepRad, -FULL_TURN, FULL_TURN);
      Arguments.requireInside("samples", samples, 1.0, 10_000.0);
      Arguments.requirePositive("reach", reachM);
    }
  }

  /**
   * Uses the random stream {@code sonar}.
   *
   * @param distance current range from the sonar to the nearest object in a direction (left
   *     positive [rad]) [m]; infinite if there is none
   */
  public SimulatedSonar(Head head, NoiseStreams streams, DoubleUnaryOperator distance) {
    super(head.rateHz(), 0.0);
    this.head = head;
    this.distance = distance;
    noise = streams.of("sonar");
  }

  @Override
  protected Ping measure(double timeS, long measuredAtMicros) {
    double bearing = StrictMath.IEEEremainder(pings++ * head.stepRad(), FULL_TURN);
    double perSampleM = head.reachM() / head.samples();
    double echo = distance.applyAsDouble(bearing) / perSampleM - 0.5;
    byte[] strengths = new byte[head.samples()];
    for (int i = 0; i < strengths.length; i++) {
      double off = (i - echo) / ECHO_SAMPLES;
      double strength =
          STRENGTH * StrictMath.exp(-0.5 * off * off) + BACKGROUND * noise.nextDouble();
      strengths[i] = (byte) Math.round(Math.min(FULL_SCALE, strength));
    }
    return new Ping(measuredAtMicros, bearing, perSampleM, strengths);
  }
}
