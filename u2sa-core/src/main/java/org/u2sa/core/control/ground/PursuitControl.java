package org.u2sa.core.control.ground;

import java.util.Optional;
import java.util.Set;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/** Regulated pure pursuit, for whatever motors the vehicle has. */
abstract class PursuitControl extends GroundControl {
  private final PursuitLaw law;
  private final Trim speedTrim = new Trim("SPEED TRIM");
  private final Trim turnTrim = new Trim("TURN TRIM");

  /** Subclasses must be able to answer {@link #settings} once this has returned. */
  PursuitControl(ServiceContext context) {
    super(context);
    calibration(); // wrong values must fail before the drive
    getVariable(PursuitVariables.SPEED_GAIN);
    getVariable(PursuitVariables.SPEED_TRIM);
    getVariable(PursuitVariables.TURN_GAIN);
    getVariable(PursuitVariables.TURN_TRIM);
    law = new PursuitLaw(settings());
  }

  /** Declares and reads the variables; called in the constructor, too. */
  abstract PursuitSettings settings();

  /**
   * Commands the motors so that the vehicle moves so.
   *
   * @param trim what must be told more for that
   */
  abstract void command(Drive drive, Drive trim);

  /** The motion that the motors were commanded last, by whatever control. */
  abstract Drive lastDrive();

  /** What the motors make of commands. */
  final DriveCalibration calibration() {
    return DriveCalibration.of(this);
  }

  @Override
  final void drive(Optional<GroundTarget> target, Measured measured, double stepS) {
    Drive drive = law.step(target, stepS);
    boolean moves = drive.speedMps() > 0.0;
    double speedMps =
        speedTrim.step(
            moves,
            drive.speedMps(),
            measured.forwardMps(),
            getVariable(PursuitVariables.SPEED_GAIN),
            getVariable(PursuitVariables.SPEED_TRIM),
            stepS);
    double yawRate =
        turnTrim.step(
            moves,
            drive.yawRateRadPerS(),
            measured.yawRateRadPerS(),
            getVariable(PursuitVariables.TURN_GAIN),
            Math.toRadians(getVariable(PursuitVariables.TURN_TRIM)),
            stepS);
    command(drive, new Drive(speedMps, yawRate));
  }

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
    turnTrim.handOver(state);
  }

  @Override
  protected final void takeOver(HandOver state) {
    super.takeOver(state);
    if (state.className().equals(getClass().getName())) {
      law.takeOver(state);
      speedTrim.takeOver(state);
      turnTrim.takeOver(state);
    } else {
      law.startFrom(lastDrive());
    }
  }
}
