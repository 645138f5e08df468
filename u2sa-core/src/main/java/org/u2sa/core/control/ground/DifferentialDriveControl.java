package org.u2sa.core.control.ground;

import static org.u2sa.core.control.ground.PursuitVariables.number;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/**
 * The control of the thesis's ground vehicle (4.6.2.5), kept to teach from: a proportional
 * controller for each wheel. In: navigation, state. Out: actuation of the left and the right motor,
 * once for each state.
 *
 * <p>Both wheels follow the distance of the point to go to, up to a limit, and its direction with
 * opposite signs. It knows no acceleration and no speed over ground: for those see {@link
 * DifferentialPursuitControl}. Without fresh navigation both wheels stop.
 */
public final class DifferentialDriveControl extends ControlSystem {
  static final VariableDeclaration<Double> DISTANCE_GAIN =
      number("DISTANCE GAIN", "%/m", 0.0, 1000.0, 60.0, "Both wheels for each metre of distance.");
  static final VariableDeclaration<Double> SPEED_LIMIT =
      number("SPEED LIMIT", "%", 0.0, 100.0, 60.0, "Most of what distance gives both wheels.");
  static final VariableDeclaration<Double> HEADING_GAIN =
      number(
          "HEADING GAIN",
          "%/rad",
          0.0,
          500.0,
          45.0,
          "Each wheel for each radian of direction: right wheel forwards, left wheel backwards, for a point to the left.");
  static final VariableDeclaration<Double> TOLERANCE =
      number("TOLERANCE", "m", 0.01, 10.0, 0.15, "Distance at which both wheels stop.");

  static final VariableDeclaration<Double> MISMATCH_GAIN =
      number(
          "MISMATCH GAIN",
          "1/s",
          0.0,
          10.0,
          0.5,
          "Share of what HEADING GAIN gives that is added in a second, for motors that are not alike; 0: no feedback.");

  private static final double ALIGNED_RAD = 0.6; // farther aside it is to turn, not to learn
  private static final double FULL_PERCENT = 100.0;

  private final GroundControl ground = new GroundControl(this);
  private final WheelBalance balance = new WheelBalance();

  /** Called by the launcher. */
  public DifferentialDriveControl(ServiceContext context) {
    super(context, "Control");
    Motors.declare(this);
    getVariable(DISTANCE_GAIN); // wrong values must fail before the drive
    getVariable(SPEED_LIMIT);
    getVariable(HEADING_GAIN);
    getVariable(TOLERANCE);
    getVariable(MISMATCH_GAIN);
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<GroundTarget> target =
        ground.target(state, point, point.flatMap(this::stateOf), point.flatMap(this::nedOf));
    GroundControl.Measured measured = ground.measured(state, stepS());
    double ahead = 0.0; // [%]
    double turn = 0.0;
    OptionalDouble error = OptionalDouble.empty();
    if (target.isPresent() && target.get().distanceM() > getVariable(TOLERANCE)) {
      double bearing = target.get().bearingRad();
      ahead =
          Math.min(getVariable(SPEED_LIMIT), getVariable(DISTANCE_GAIN) * target.get().distanceM())
              * Math.max(0.0, Math.cos(bearing)); // not away from a point behind
      turn = getVariable(HEADING_GAIN) * bearing;
      if (measured.yawRateRadPerS().isPresent() && Math.abs(bearing) < ALIGNED_RAD) {
        error = OptionalDouble.of(bearing); // the integral of a yaw rate: a PI controller
      }
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
    commandShare(Motors.left(this), shares.left());
    commandShare(Motors.right(this), shares.right());
  }

  private WheelBalance.Settings feedback() {
    return new WheelBalance.Settings(
        0.0,
        0.0,
        getVariable(MISMATCH_GAIN),
        0.0,
        getVariable(Motors.MISMATCH_LIMIT) / FULL_PERCENT,
        getVariable(HEADING_GAIN) / FULL_PERCENT);
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    balance.handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    balance.takeOver(state);
  }

  @Override
  protected Map<String, Double> neutral() {
    return Motors.neutral(this);
  }
}
