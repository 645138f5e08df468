package org.u2sa.core.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/** Regulated pure pursuit, for whatever motors the vehicle has. */
abstract class PursuitControl extends GroundControl {
  private final PursuitLaw law;
  private final SpeedTrim trim = new SpeedTrim();

  /** Subclasses must be able to answer {@link #settings} once this has returned. */
  PursuitControl(ServiceContext context) {
    super(context);
    calibration(); // wrong values must fail before the drive
    getVariable(PursuitVariables.SPEED_GAIN);
    getVariable(PursuitVariables.SPEED_TRIM);
    law = new PursuitLaw(settings());
  }

  /** Declares and reads the variables; called in the constructor, too. */
  abstract PursuitSettings settings();

  /**
   * Commands the motors so that the vehicle moves so.
   *
   * @param trimMps by how much faster the wheels must be told to go for that, straight ahead [m/s]
   */
  abstract void command(Drive drive, double trimMps);

  /** The motion that the motors were commanded last, by whatever control. */
  abstract Drive lastDrive();

  /** What the motors make of commands. */
  final DriveCalibration calibration() {
    return DriveCalibration.of(this);
  }

  @Override
  final void drive(Optional<GroundTarget> target, OptionalDouble forwardMps, double stepS) {
    Drive drive = law.step(target, stepS);
    double trimMps =
        trim.step(
            drive,
            forwardMps,
            getVariable(PursuitVariables.SPEED_GAIN),
            getVariable(PursuitVariables.SPEED_TRIM),
            stepS);
    command(drive, trimMps);
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
    trim.handOver(state);
  }

  @Override
  protected final void takeOver(HandOver state) {
    super.takeOver(state);
    if (state.className().equals(getClass().getName())) {
      law.takeOver(state);
      trim.takeOver(state);
    } else {
      law.startFrom(lastDrive());
    }
  }
}
