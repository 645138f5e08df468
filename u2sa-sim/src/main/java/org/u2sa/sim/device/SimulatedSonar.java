package org.u2sa.sim.device;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.u2sa.device.Sonar;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/** A sonar whose transducer turns by one step after each ping, over a faint background of noise. */
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
   * How it looks around.
   *
   * @param rateHz pings a second
   * @param stepRad from each ping to the next, to the left positive [rad]
   * @param samples of each echo
   * @param reachM distance of the last sample's end [m]
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
   * Takes the stream {@code sonar}.
   *
   * @param distance to the nearest thing in a direction, to the left positive [rad], from the sonar
   *     now [m]; infinite if there is none
   */
  public SimulatedSonar(Head head, NoiseStreams streams, DoubleUnaryOperator distance) {
    super(head.rateHz(), 0.0);
    this.head = head;
    this.distance = distance;
    noise = streams.of("sonar");
  }

  @Override
  Ping measure(double timeS, long measuredAtMicros) {
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
