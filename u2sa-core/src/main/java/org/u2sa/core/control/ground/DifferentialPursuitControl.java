package org.u2sa.core.control.ground;

import static org.u2sa.core.control.ground.PursuitVariables.number;

import java.util.Map;
import org.u2sa.interfaces.Variable;
import org.u2sa.service.ServiceContext;

/**
 * Drives a differential ground vehicle along its navigation points by regulated pure pursuit, with
 * turns on the spot (the default for thesis 4.6.2.5). In: navigation, state. Out: actuation of the
 * left and the right motor, once for each state. Without fresh navigation, or without knowing where
 * it is, the vehicle brakes and stands.
 */
public final class DifferentialPursuitControl extends PursuitControl {
  static final Variable<Double> TRACK =
      number("TRACK", "m", 0.05, 10.0, 0.44, "Distance between the wheels of both sides.");
  static final Variable<Double> SPOT_TURN_ABOVE =
      number(
          "SPOT TURN ABOVE",
          "deg",
          5.0,
          180.0,
          35.0,
          "Direction of the point to go to from which on the vehicle turns on the spot.");
  static final Variable<Double> SPOT_TURN_BELOW =
      number(
          "SPOT TURN BELOW",
          "deg",
          1.0,
          180.0,
          8.0,
          "Direction of the point at which it has turned enough.");
  static final Variable<Double> SPOT_TURN_GAIN =
      number("SPOT TURN GAIN", "1/s", 0.1, 20.0, 2.0, "Yaw rate for each radian of direction.");

  private static final double TIGHTEST = 10.0; // [1/m]; tighter is as good as on the spot

  /** Called by the launcher. */
  public DifferentialPursuitControl(ServiceContext context) {
    super(context);
    Motors.declare(this);
    getVariable(TRACK);
  }

  @Override
  PursuitSettings settings() {
    return PursuitVariables.settings(
        this,
        TIGHTEST,
        new PursuitSettings.SpotTurn(
            true,
            Math.toRadians(getVariable(SPOT_TURN_ABOVE)),
            Math.toRadians(Math.min(getVariable(SPOT_TURN_BELOW), getVariable(SPOT_TURN_ABOVE))),
            getVariable(SPOT_TURN_GAIN)));
  }

  @Override
  void command(Drive drive, Drive trim) {
    Drive trimmed =
        new Drive(
            drive.speedMps() + trim.speedMps(), drive.yawRateRadPerS() + trim.yawRateRadPerS());
    DriveCalibration motor = calibration();
    WheelSpeeds wheels = WheelSpeeds.of(trimmed, getVariable(TRACK), motor.maxMps());
    commandShare(Motors.left(this), motor.share(wheels.leftMps()));
    commandShare(Motors.right(this), motor.share(wheels.rightMps()));
  }

  @Override
  Drive lastDrive() {
    DriveCalibration motor = calibration();
    return new WheelSpeeds(
            motor.speedMps(lastShare(Motors.left(this))),
            motor.speedMps(lastShare(Motors.right(this))))
        .drive(getVariable(TRACK));
  }

  @Override
  protected Map<String, Double> neutral() {
    return Motors.neutral(this);
  }
}
