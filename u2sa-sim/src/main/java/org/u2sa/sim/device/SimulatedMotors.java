package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.device.port.MotorController;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.sensor.EncoderModel;
import org.u2sa.sim.sensor.NoiseStreams;

/**
 * A two-channel motor controller of a differential-drive vehicle with wheel encoders; the first
 * channel is the left motor.
 */
public final class SimulatedMotors extends SimulatedDevice<MotorController.Counts>
    implements MotorController {
  private static final double RATE_HZ = 50.0;
  private static final double FULL_PERCENT = 100.0;

  private final Supplier<GroundState> truth;
  private final Outputs outputs;
  private final EncoderModel left;
  private final EncoderModel right;
  private final long timeoutMicros;
  private DriveCommand wanted = DriveCommand.neutral();
  private volatile Told told = new Told(DriveCommand.neutral(), 0);

  private record Told(DriveCommand command, long untilMicros) {}

  /** The motors behind the controller. */
  @FunctionalInterface
  public interface Outputs {
    /** Applies both commands from now until their time-out [µs of the run's clock]. */
    void drive(DriveCommand command, long nowMicros, long untilMicros);
  }

  /**
   * Uses the random streams {@code left encoder} and {@code right encoder}.
   *
   * @param countsPerTurn counts per wheel revolution
   * @param timeoutS command time-out, after which the motors stop [s]
   * @param truth current state of the vehicle
   */
  public SimulatedMotors(
      double countsPerTurn, double timeoutS, NoiseStreams streams, Supplier<GroundState> truth) {
    this(countsPerTurn, timeoutS, streams, truth, (command, nowMicros, untilMicros) -> {});
  }

  /**
   * Like the other constructor, with motors that receive each command.
   *
   * @param outputs called at each reading
   */
  public SimulatedMotors(
      double countsPerTurn,
      double timeoutS,
      NoiseStreams streams,
      Supplier<GroundState> truth,
      Outputs outputs) {
    super(RATE_HZ, 0.0);
    this.outputs = outputs;
    this.truth = truth;
    left = new EncoderModel(countsPerTurn, 0.0, streams, "left encoder");
    right = new EncoderModel(countsPerTurn, 0.0, streams, "right encoder");
    timeoutMicros = Math.round(timeoutS * 1e6);
  }

  /** Motor commands in effect at the given time of the run's clock [µs]. Thread-safe. */
  public DriveCommand command(long nowMicros) {
    Told now = told;
    return nowMicros <= now.untilMicros ? now.command : DriveCommand.neutral();
  }

  @Override
  void tell(long nowMicros) {
    told = new Told(wanted, nowMicros + timeoutMicros);
    outputs.drive(wanted, nowMicros, nowMicros + timeoutMicros);
  }

  @Override
  boolean outlivesLoss() {
    return false;
  }

  @Override
  protected Counts measure(double timeS, long measuredAtMicros) {
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
    // the motors keep running until the time-out
  }

  @Override
  public void close() {
    stop(0);
  }
}
