package org.u2sa.core.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/** Regulated pure pursuit, for whatever motors the vehicle has. */
abstract class PursuitControl extends GroundControl {
  private final PursuitLaw law;
  private final Reference reference = new Reference();
  private final TurnTrim speedTrim = new TurnTrim("SPEED TRIM");
  private final MotionWatch watch = new MotionWatch();
  private boolean atFullPower;

  /** Subclasses must be able to answer {@link #settings} once this has returned. */
  PursuitControl(ServiceContext context) {
    super(context);
    calibration(); // wrong values must fail before the drive
    getVariable(PursuitVariables.SPEED_GAIN);
    getVariable(PursuitVariables.TURN_GAIN);
    getVariable(PursuitVariables.RESPONSE_TIME);
    getVariable(PursuitVariables.STALL_TIME);
    getVariable(PursuitVariables.STALL_PAUSE);
    law = new PursuitLaw(settings());
  }

  /** Declares and reads the variables; called in the constructor, too. */
  abstract PursuitSettings settings();

  /**
   * Commands the motors so that the vehicle moves so.
   *
   * @param trimMps what must be told more for that speed [m/s]
   * @param yawErrorRadPerS wanted yaw rate less the measured one; empty if unknown
   * @return what the motors are asked for by what they can: more than 1 if they cannot
   */
  abstract double command(
      Drive drive, double trimMps, OptionalDouble yawErrorRadPerS, double stepS);

  /** Forgets what feedback has learned of a load that the motors did not move. */
  abstract void relax();

  /** The motion that the motors were commanded last, by whatever control. */
  abstract Drive lastDrive();

  /** What the motors make of commands. */
  final DriveCalibration calibration() {
    return DriveCalibration.of(this);
  }

  @Override
  final void drive(Optional<GroundTarget> target, Measured measured, double stepS) {
    Drive drive = law.step(watch.rests(measured, stepS) ? Optional.empty() : target, stepS);
    Drive due = reference.step(drive, getVariable(PursuitVariables.RESPONSE_TIME), stepS);
    double trim =
        speedTrim.step(
            drive,
            error(due.speedMps(), measured.forwardMps()),
            atFullPower,
            getVariable(PursuitVariables.SPEED_GAIN),
            calibration().maxMps(),
            stepS);
    double effort =
        command(drive, trim, error(due.yawRateRadPerS(), measured.yawRateRadPerS()), stepS);
    atFullPower = effort > 1.0;
    watch
        .see(
            drive,
            measured,
            effort,
            getVariable(PursuitVariables.STALL_TIME),
            getVariable(PursuitVariables.STALL_PAUSE),
            stepS)
        .ifPresent(this::stalled);
  }

  private void stalled(String words) {
    trouble(words);
    relax();
  }

  private static OptionalDouble error(double wanted, OptionalDouble measured) {
    return measured.isPresent()
        ? OptionalDouble.of(wanted - measured.getAsDouble())
        : OptionalDouble.empty();
  }

  /** Hands over what was learned of the motors. */
  abstract void handOverMotors(HandOver state);

  /** Takes over what was learned of the motors, by whatever control. */
  abstract void takeOverMotors(HandOver state);

  /** Drives on with other gains and limits. */
  @Override
  protected final void configurationChanged(Set<String> variableNames) {
    law.settings(settings());
  }

  @Override
  protected final void handOver(HandOver state) {
    super.handOver(state);
    law.handOver(state);
    speedTrim.handOver(state);
    handOverMotors(state);
  }

  @Override
  protected final void takeOver(HandOver state) {
    super.takeOver(state);
    takeOverMotors(state);
    if (state.className().equals(getClass().getName())) {
      law.takeOver(state);
      speedTrim.takeOver(state);
    } else {
      law.startFrom(lastDrive());
    }
  }
}
