package org.u2sa.sim.device;

import java.util.Random;
import java.util.function.Supplier;
import org.u2sa.device.Heading;
import org.u2sa.device.Imu;
import org.u2sa.device.Orientation;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;

/** An IMU with white noise, and gyroscopes with a constant bias. */
public final class SimulatedImu extends SimulatedDevice<Orientation> implements Imu {
  private final Errors errors;
  private final Supplier<Orientation> truth;
  private final Random noise;
  private final double[] biasRadPerS = new double[3];

  /**
   * How good it is; standard deviations.
   *
   * @param rateHz readings a second
   * @param attitudeRad of roll and pitch [rad]
   * @param headingRad of the heading [rad]
   * @param rateRadPerS of each reading's rates [rad/s]
   * @param biasRadPerS of the gyroscopes' biases, drawn once [rad/s]
   */
  public record Errors(
      double rateHz,
      double attitudeRad,
      double headingRad,
      double rateRadPerS,
      double biasRadPerS) {
    /**
     * VectorNav's VN-100 by its data sheet: 0.5° roll and pitch, 2° magnetic heading, 0.0035
     * °/s/√Hz over 40 Hz; 10°/h of bias.
     */
    public static Errors vn100() {
      return new Errors(40.0, 8.7e-3, 3.5e-2, 2.8e-4, 4.8e-5);
    }
  }

  /**
   * Takes the stream {@code imu}.
   *
   * @param truth what an IMU without errors would read now; its heading decides whether north is
   *     true north
   */
  public SimulatedImu(Errors errors, NoiseStreams streams, Supplier<Orientation> truth) {
    super(errors.rateHz(), 0.0);
    Arguments.requireInside("attitude noise", errors.attitudeRad(), 0.0, 1.0);
    Arguments.requireInside("heading noise", errors.headingRad(), 0.0, 1.0);
    this.errors = errors;
    this.truth = truth;
    noise = streams.of("imu");
    for (int i = 0; i < biasRadPerS.length; i++) {
      biasRadPerS[i] = errors.biasRadPerS() * noise.nextGaussian();
    }
  }

  @Override
  Orientation measure(double timeS, long measuredAtMicros) {
    Orientation o = truth.get();
    double headingDeg = Math.toDegrees(noisy(o.heading().headingRad(), errors.headingRad()));
    return new Orientation(
        measuredAtMicros,
        noisy(o.rollRad(), errors.attitudeRad()),
        noisy(o.pitchRad(), errors.attitudeRad()),
        Heading.ofDegrees(measuredAtMicros, headingDeg, o.heading().isTrue()),
        noisy(o.xRateRadPerS() + biasRadPerS[0], errors.rateRadPerS()),
        noisy(o.yRateRadPerS() + biasRadPerS[1], errors.rateRadPerS()),
        noisy(o.zRateRadPerS() + biasRadPerS[2], errors.rateRadPerS()));
  }

  private double noisy(double value, double sigma) {
    return value + sigma * noise.nextGaussian();
  }
}
