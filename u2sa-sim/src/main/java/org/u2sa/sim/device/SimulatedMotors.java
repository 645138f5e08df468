package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.device.MotorController;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.sensor.EncoderModel;
import org.u2sa.sim.sensor.NoiseStreams;

/**
 * A controller of a differential vehicle's two motors, the left one being the first, with encoders
 * at the wheels.
 */
public final class SimulatedMotors extends SimulatedDevice<MotorController.Counts>
    implements MotorController {
  private static final double RATE_HZ = 50.0;
  private static final double FULL_PERCENT = 100.0;

  private final Supplier<GroundState> truth;
  private final EncoderModel left;
  private final EncoderModel right;
  private final long timeoutMicros;
  private DriveCommand wanted = DriveCommand.neutral();
  private volatile Told told = new Told(DriveCommand.neutral(), 0);

  private record Told(DriveCommand command, long untilMicros) {}

  /**
   * Takes the streams {@code left encoder} and {@code right encoder}.
   *
   * @param countsPerTurn of each wheel
   * @param timeoutS after which the motors stop without being told to go on [s]
   * @param truth of the vehicle, now
   */
  public SimulatedMotors(
      double countsPerTurn, double timeoutS, NoiseStreams streams, Supplier<GroundState> truth) {
    super(RATE_HZ, 0.0);
    this.truth = truth;
    left = new EncoderModel(countsPerTurn, 0.0, streams, "left encoder");
    right = new EncoderModel(countsPerTurn, 0.0, streams, "right encoder");
    timeoutMicros = Math.round(timeoutS * 1e6);
  }

  /** What the motors get at a moment of the run's clock [µs]. Safe from any thread. */
  public DriveCommand command(long nowMicros) {
    Told now = told;
    return nowMicros <= now.untilMicros ? now.command : DriveCommand.neutral();
  }

  @Override
  void tell(long nowMicros) {
    told = new Told(wanted, nowMicros + timeoutMicros);
  }

  @Override
  boolean outlivesLoss() {
    return false;
  }

  @Override
  Counts measure(double timeS, long measuredAtMicros) {
    GroundState state = truth.get();
    return new Counts(
        measuredAtMicros,
        (int) left.sample(state.leftWheelRad()),
        (int) right.sample(state.rightWheelRad()),
        OptionalDouble.of(state.batteryV()));
  }

  @Override
  public void drive(double first, double second) {
    wanted = new DriveCommand(first / FULL_PERCENT, second / FULL_PERCENT);
  }

  @Override
  public void stop(long nowMicros) {
    wanted = DriveCommand.neutral();
    if (isConnected()) {
      tell(nowMicros);
    }
  }

  @Override
  public void leave() {
    // the motors turn on until the time-out
  }

  @Override
  public void close() {
    stop(0);
  }
}
