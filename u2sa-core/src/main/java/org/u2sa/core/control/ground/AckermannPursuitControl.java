package org.u2sa.core.control.ground;

import static org.u2sa.core.control.ground.PursuitVariables.number;

import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/**
 * Drives a ground vehicle with steered front wheels along its navigation points by regulated pure
 * pursuit. In: navigation, state. Out: actuation of throttle (forwards positive) and steering (to
 * the right positive), once for each state. Without fresh navigation, or without knowing where it
 * is, the vehicle brakes and stands.
 */
public final class AckermannPursuitControl extends PursuitControl {
  static final Variable<Double> WHEELBASE =
      number("WHEELBASE", "m", 0.05, 20.0, 0.33, "Distance from the front axle to the rear one.");
  static final Variable<Double> STEERING_ANGLE =
      number(
          "STEERING ANGLE",
          "deg",
          1.0,
          70.0,
          24.0,
          "Of the front wheels at 100 %, mean of both; with WHEELBASE it makes the tightest curve.");
  static final Variable<String> THROTTLE =
      Variable.text("THROTTLE ACTUATOR")
          .ifAbsent("THROTTLE")
          .describedAs("Name of the actuator of the drive, forwards positive.");
  static final Variable<String> STEERING =
      Variable.text("STEERING ACTUATOR")
          .ifAbsent("STEERING")
          .describedAs("Name of the actuator of the steering, to the right positive.");

  private static final double SLOWEST_MPS = 0.1; // slower, the steering stays where it is

  private double misalignment; // curvature that the steering lacks [1/m]; kept while it stands

  /** Called by the launcher. */
  public AckermannPursuitControl(ServiceContext context) {
    super(context);
    getVariable(THROTTLE); // wrong values must fail before the drive
    getVariable(STEERING);
  }

  @Override
  PursuitSettings settings() {
    double tightest = Math.tan(steeringAngleRad()) / getVariable(WHEELBASE);
    return PursuitVariables.settings(this, tightest, PursuitSettings.SpotTurn.NONE);
  }

  private double steeringAngleRad() {
    return Math.toRadians(getVariable(STEERING_ANGLE));
  }

  @Override
  double command(Drive drive, double trimMps, OptionalDouble yawErrorRadPerS, double stepS) {
    double steering = lastShare(getVariable(STEERING));
    if (drive.speedMps() > SLOWEST_MPS) {
      if (yawErrorRadPerS.isPresent()) {
        double error = yawErrorRadPerS.getAsDouble() / drive.speedMps();
        double most = settings().largestCurvature();
        double more = getVariable(PursuitVariables.TURN_GAIN) * stepS * error;
        misalignment = Math.max(-most, Math.min(most, misalignment + more));
      }
      double curvature = drive.yawRateRadPerS() / drive.speedMps() + misalignment;
      // tan δ = L / R, a bicycle without slip (Rajamani: Vehicle Dynamics and Control, eq. 2.10)
      steering = -Math.atan(getVariable(WHEELBASE) * curvature) / steeringAngleRad();
    }
    double throttle = calibration().share(drive.speedMps() + trimMps);
    commandShare(getVariable(THROTTLE), throttle);
    commandShare(getVariable(STEERING), steering);
    return Math.abs(throttle);
  }

  @Override
  void relax() {
    // what it has learned of its steering holds whatever it carries
  }

  @Override
  void handOverMotors(HandOver state) {
    state.number("MISALIGNMENT", misalignment);
  }

  @Override
  void takeOverMotors(HandOver state) {
    misalignment = state.number("MISALIGNMENT").orElse(0.0);
  }

  @Override
  Drive lastDrive() {
    double speed = calibration().speedMps(lastShare(getVariable(THROTTLE)));
    double angle = -steeringAngleRad() * lastShare(getVariable(STEERING));
    return new Drive(speed, speed * Math.tan(angle) / getVariable(WHEELBASE));
  }

  @Override
  protected Map<String, Double> neutral() {
    return Map.of(getVariable(THROTTLE), 0.0, getVariable(STEERING), 0.0);
  }
}
