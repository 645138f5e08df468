package org.u2sa.control.ground;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Control of the thesis's ground vehicle (4.6.2.5), kept for teaching: one proportional controller
 * per wheel. In: navigation, state. Out: actuation of the left and the right motor, once for each
 * state.
 *
 * <p>Both wheels are proportional to the distance of the target, up to a limit, and to its bearing
 * with opposite signs. Acceleration and ground speed are not considered; for those see {@link
 * DifferentialPursuitControl}. Without fresh navigation both wheels stop.
 */
public final class DifferentialDriveControl extends GroundControl {
  private record Gains(
      @Variable(unit = "%/m", min = 0, max = 1000, ifAbsent = 60)
          @Description("Command of both wheels per metre of distance to the point.")
          double distanceGain,
      @Variable(unit = "%", min = 0, max = 100, ifAbsent = 60)
          @Description("Maximum command of both wheels due to distance.")
          double speedLimit,
      @Variable(unit = "%/rad", min = 0, max = 500, ifAbsent = 45)
          @Description(
              "Command of each wheel per bearing: right wheel forward, left wheel backward, for a point to the left.")
          double headingGain,
      @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.15)
          @Description("Distance to the point at which both wheels stop.")
          double tolerance,
      @Variable(unit = "1/s", min = 0, max = 10, ifAbsent = 0.5)
          @Description(
              "Integral gain on the command of HEADING GAIN, for mismatched motors; 0: no feedback.")
          double mismatchGain) {}

  private static final double ALIGNED_RAD = 0.6; // learns only below this bearing, when not turning
  private static final double FULL_PERCENT = 100.0;

  private final Settings<Gains> gains = settings(Gains.class);
  private final Settings<Motors> motors = settings(Motors.class);
  private final WheelBalance balance = new WheelBalance();

  public DifferentialDriveControl(ServiceContext context) {
    super(context);
  }

  @Override
  List<String> motors() {
    return motors.get().names();
  }

  @Override
  protected boolean obeysWithoutState() {
    return true;
  }

  /** Its gains imply no speed limits. */
  @Override
  boolean isDrivenByHand() {
    return false;
  }

  @Override
  void drive(StateInformation state, Optional<GroundTarget> target, Measured measured) {
    double ahead = 0.0; // [%]
    double turn = 0.0;
    OptionalDouble error = OptionalDouble.empty();
    if (target.isPresent() && target.get().distanceM() > gains.get().tolerance()) {
      double bearing = target.get().bearingRad();
      ahead =
          Math.min(gains.get().speedLimit(), gains.get().distanceGain() * target.get().distanceM())
              * Math.max(0.0, Math.cos(bearing)); // do not drive away from a point behind
      turn = gains.get().headingGain() * bearing;
      if (measured.yawRateRadPerS().isPresent() && Math.abs(bearing) < ALIGNED_RAD) {
        error = OptionalDouble.of(bearing); // integral of yaw rate: a PI controller
      }
    } else if (target.isPresent()) {
      turn = gains.get().headingGain() * target.get().turnRad().orElse(0.0);
    }
    WheelShares shares =
        balance
            .step(
                new WheelShares((ahead - turn) / FULL_PERCENT, (ahead + turn) / FULL_PERCENT),
                ahead / FULL_PERCENT,
                error,
                feedback(),
                stepS())
            .possible();
    commandShare(motors.get().leftActuator(), shares.left());
    commandShare(motors.get().rightActuator(), shares.right());
  }

  private WheelBalance.Settings feedback() {
    return new WheelBalance.Settings(
        0.0,
        0.0,
        gains.get().mismatchGain(),
        0.0,
        motors.get().mismatchLimit() / FULL_PERCENT,
        gains.get().headingGain() / FULL_PERCENT,
        0.0,
        1.0);
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    balance.transfer(Transfer.saving(state));
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    balance.takeOver(state, isSwap());
  }
}
