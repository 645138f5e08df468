package org.u2sa.sim.device;

import java.util.function.DoubleSupplier;
import org.u2sa.device.WheelEncoder;
import org.u2sa.sim.sensor.EncoderModel;
import org.u2sa.sim.sensor.NoiseStreams;

/** Encoders at two wheels, with whole and missed counts. */
public final class SimulatedEncoder extends SimulatedDevice<WheelEncoder.Ticks>
    implements WheelEncoder {
  private final EncoderModel left;
  private final EncoderModel right;
  private final DoubleSupplier leftRad;
  private final DoubleSupplier rightRad;

  /**
   * Takes the streams {@code left ticks} and {@code right ticks}.
   *
   * @param rateHz readings a second
   * @param countsPerTurn of each wheel
   * @param missed share of counts that get lost, 0…1
   * @param leftRad by which the left wheel has turned forward since the start, now [rad]
   * @param rightRad by which the right wheel has turned forward since the start, now [rad]
   */
  public SimulatedEncoder(
      double rateHz,
      double countsPerTurn,
      double missed,
      NoiseStreams streams,
      DoubleSupplier leftRad,
      DoubleSupplier rightRad) {
    super(rateHz, 0.0);
    left = new EncoderModel(countsPerTurn, missed, streams, "left ticks");
    right = new EncoderModel(countsPerTurn, missed, streams, "right ticks");
    this.leftRad = leftRad;
    this.rightRad = rightRad;
  }

  @Override
  Ticks measure(double timeS, long measuredAtMicros) {
    return new Ticks(
        measuredAtMicros,
        (int) left.sample(leftRad.getAsDouble()),
        (int) right.sample(rightRad.getAsDouble()));
  }
}
