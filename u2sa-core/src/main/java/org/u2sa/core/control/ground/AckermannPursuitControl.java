package org.u2sa.core.control.ground;

import static org.u2sa.core.control.ground.PursuitVariables.number;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/**
 * Drives a ground vehicle with steered front wheels along its navigation points by regulated pure
 * pursuit. In: navigation, state. Out: actuation of throttle (forwards positive) and steering (to
 * the right positive), once for each state. Without fresh navigation, or without knowing where it
 * is, the vehicle brakes and stands.
 */
public final class AckermannPursuitControl extends ControlSystem {
  static final VariableDeclaration<Double> WHEELBASE =
      number("WHEELBASE", "m", 0.05, 20.0, 0.33, "Distance from the front axle to the rear one.");
  static final VariableDeclaration<Double> STEERING_ANGLE =
      number(
          "STEERING ANGLE",
          "deg",
          1.0,
          70.0,
          24.0,
          "Of the front wheels at 100 %, mean of both; with WHEELBASE it makes the tightest curve.");
  static final VariableDeclaration<String> THROTTLE =
      VariableDeclaration.text("THROTTLE ACTUATOR")
          .ifAbsent("THROTTLE")
          .describedAs("Name of the actuator of the drive, forwards positive.");
  static final VariableDeclaration<String> STEERING =
      VariableDeclaration.text("STEERING ACTUATOR")
          .ifAbsent("STEERING")
          .describedAs("Name of the actuator of the steering, to the right positive.");

  private static final double SLOWEST_MPS = 0.1; // slower, the steering stays where it is

  private double misalignment; // curvature that the steering lacks [1/m]; kept while it stands

  private final GroundControl ground = new GroundControl(this);
  private final PursuitControl pursuit;

  /** Called by the launcher. */
  public AckermannPursuitControl(ServiceContext context) {
    super(context, "Control");
    pursuit = new PursuitControl(this, settings());
    getVariable(THROTTLE); // wrong values must fail before the drive
    getVariable(STEERING);
  }

  private PursuitSettings settings() {
    return PursuitVariables.settings(this, tightest(), PursuitSettings.SpotTurn.NONE);
  }

  /** Curvature at full steering [1/m]. */
  private double tightest() {
    return Math.tan(steeringAngleRad()) / getVariable(WHEELBASE);
  }

  private double steeringAngleRad() {
    return Math.toRadians(getVariable(STEERING_ANGLE));
  }

  /** Drives on with other gains and limits. */
  @Override
  protected void configurationChanged(Set<String> variableNames) {
    pursuit.settings(settings());
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<GroundTarget> target =
        ground.target(state, point, point.flatMap(this::stateOf), point.flatMap(this::nedOf));
    GroundControl.Measured measured = ground.measured(state, stepS());
    PursuitControl.Demand demand = pursuit.step(target, measured, stepS());
    pursuit.commanded(demand, drive(demand), measured, stepS()).ifPresent(this::trouble);
  }

  /** Commands the motors; returns what the drive is asked for by what it can. */
  private double drive(PursuitControl.Demand demand) {
    Drive drive = demand.drive();
    double steering = lastShare(getVariable(STEERING));
    if (drive.speedMps() > SLOWEST_MPS) {
      if (demand.yawErrorRadPerS().isPresent()) {
        double error = demand.yawErrorRadPerS().getAsDouble() / drive.speedMps();
        double more = getVariable(PursuitVariables.TURN_GAIN) * stepS() * error;
        misalignment = Math.max(-tightest(), Math.min(tightest(), misalignment + more));
      }
      double curvature = drive.yawRateRadPerS() / drive.speedMps() + misalignment;
      // tan δ = L / R, a bicycle without slip (Rajamani: Vehicle Dynamics and Control, eq. 2.10)
      steering = -Math.atan(getVariable(WHEELBASE) * curvature) / steeringAngleRad();
    }
    double throttle = pursuit.calibration().share(drive.speedMps() + demand.trimMps());
    commandShare(getVariable(THROTTLE), throttle);
    commandShare(getVariable(STEERING), steering);
    return Math.abs(throttle);
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    pursuit.handOver(state);
    state.number("MISALIGNMENT", misalignment);
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    misalignment = state.number("MISALIGNMENT").orElse(0.0);
    pursuit.takeOver(state, isOfMyClass(state), lastDrive());
  }

  /** The motion that the motors were commanded last, by whatever control. */
  private Drive lastDrive() {
    double speed = pursuit.calibration().speedMps(lastShare(getVariable(THROTTLE)));
    double angle = -steeringAngleRad() * lastShare(getVariable(STEERING));
    return new Drive(speed, speed * Math.tan(angle) / getVariable(WHEELBASE));
  }

  @Override
  protected Map<String, Double> neutral() {
    return Map.of(getVariable(THROTTLE), 0.0, getVariable(STEERING), 0.0);
  }
}
