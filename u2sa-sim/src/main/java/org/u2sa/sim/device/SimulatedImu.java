package org.u2sa.sim.device;

import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import org.u2sa.device.port.Heading;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.Orientation;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** An IMU with white noise and constant gyroscope and accelerometer biases. */
public final class SimulatedImu extends SimulatedDevice<Orientation> implements Imu {
  private final Errors errors;
  private final Supplier<Orientation> truth;
  private final Random noise;
  private final double[] biasRadPerS = new double[3];
  private final double[] biasMps2 = new double[3];

  /**
   * Error parameters, as standard deviations.
   *
   * @param rateHz readings per second
   * @param attitudeRad roll and pitch error [rad]
   * @param headingRad heading error [rad]
   * @param rateRadPerS angular-rate noise per reading [rad/s]
   * @param biasRadPerS gyroscope bias, drawn once [rad/s]
   * @param forceMps2 specific-force noise per reading [m/s²]
   * @param biasMps2 accelerometer bias, drawn once [m/s²]
   */
  public record Errors(
      double rateHz,
      double attitudeRad,
      double headingRad,
      double rateRadPerS,
      double biasRadPerS,
      double forceMps2,
      double biasMps2) {
    /**
     * VectorNav VN-100, data sheet: 0.5° roll and pitch, 2° magnetic heading, 0.0035 °/s/√Hz and
     * 0.14 mg/√Hz over 40 Hz; 10°/h and 0.04 mg of bias.
     */
    public static Errors vn100() {
      return new Errors(40.0, 8.7e-3, 3.5e-2, 2.8e-4, 4.8e-5, 6.1e-3, 4e-4);
    }
  }

  /**
   * Uses the random stream {@code imu}.
   *
   * @param truth current reading of an ideal IMU; its heading is true or magnetic, as supplied
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
    for (int i = 0; i < biasMps2.length; i++) {
      biasMps2[i] = errors.biasMps2() * noise.nextGaussian();
    }
  }

  /** Reading of an ideal IMU at a vehicle's reference point, relative to true north. */
  public static Orientation readingOf(VehicleTruth truth) {
    return new Orientation(
        0,
        truth.attitude().phi(),
        truth.attitude().theta(),
        new Heading(0, truth.headingRad(), true),
        truth.rates().x(),
        truth.rates().y(),
        truth.rates().z(),
        Optional.of(truth.specificForce()));
  }

  @Override
  protected Orientation measure(double timeS, long measuredAtMicros) {
    Orientation o = truth.get();
    double headingDeg = Math.toDegrees(noisy(o.heading().headingRad(), errors.headingRad()));
    return new Orientation(
        measuredAtMicros,
        noisy(o.rollRad(), errors.attitudeRad()),
        noisy(o.pitchRad(), errors.attitudeRad()),
        Heading.ofDegrees(measuredAtMicros, headingDeg, o.heading().isTrue()),
        noisy(o.xRateRadPerS() + biasRadPerS[0], errors.rateRadPerS()),
        noisy(o.yRateRadPerS() + biasRadPerS[1], errors.rateRadPerS()),
        noisy(o.zRateRadPerS() + biasRadPerS[2], errors.rateRadPerS()),
        o.specificForce().map(this::noisy));
  }

  private Point noisy(Point force) {
    return Point.of(
        noisy(force.x() + biasMps2[0], errors.forceMps2()),
        noisy(force.y() + biasMps2[1], errors.forceMps2()),
        noisy(force.z() + biasMps2[2], errors.forceMps2()));
  }

  private double noisy(double value, double sigma) {
    return value + sigma * noise.nextGaussian();
  }
}
