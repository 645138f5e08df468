package org.u2sa.sim.device;

import java.util.function.DoubleSupplier;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.sim.sensor.EncoderModel;
import org.u2sa.sim.sensor.NoiseStreams;

/** Two wheel encoders with quantisation and missed counts. */
public final class SimulatedEncoder extends SimulatedDevice<WheelEncoder.Ticks>
    implements WheelEncoder {
  private final EncoderModel left;
  private final EncoderModel right;
  private final DoubleSupplier leftRad;
  private final DoubleSupplier rightRad;

  /**
   * Uses the random streams {@code left ticks} and {@code right ticks}.
   *
   * @param rateHz readings per second
   * @param countsPerTurn counts per wheel revolution
   * @param missed fraction of lost counts, 0…1
   * @param leftRad current forward rotation of the left wheel since the start [rad]
   * @param rightRad current forward rotation of the right wheel since the start [rad]
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
  protected Ticks measure(double timeS, long measuredAtMicros) {
    return new Ticks(
        measuredAtMicros,
        (int) left.sample(leftRad.getAsDouble()),
        (int) right.sample(rightRad.getAsDouble()));
  }
}
