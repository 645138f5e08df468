package org.u2sa.core.control;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Control of a vehicle that keeps velocities by itself, such as one with an ArduPilot or PX4
 * autopilot: the way to the navigation point becomes speeds along the vehicle's axes and a rate of
 * turn. In: navigation, state. Out: actuation of FORWARD SPEED, LEFT SPEED, CLIMB SPEED and TURN
 * RATE.
 *
 * <p>Without fresh navigation all four are 0: the vehicle stands.
 */
public final class VelocityControl extends ControlSystem {
  static final String FORWARD = "FORWARD SPEED";
  static final String LEFT = "LEFT SPEED";
  static final String CLIMB = "CLIMB SPEED";
  static final String TURN = "TURN RATE";

  private static final double FULL_PERCENT = 100.0;

  static final Variable<Double> FULL_SPEED =
      Variable.number("FULL SPEED", "m/s")
          .range(Range.of(0.01, 100.0))
          .ifAbsent(5.0)
          .describedAs("Speed forward and sideways at 100 %, as the actuators have it.");

  static final Variable<Double> FULL_CLIMB =
      Variable.number("FULL CLIMB", "m/s")
          .range(Range.of(0.01, 50.0))
          .ifAbsent(2.0)
          .describedAs("Speed upwards at 100 %, as the actuators have it.");

  static final Variable<Double> FULL_TURN =
      Variable.number("FULL TURN", "rad/s")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(1.0)
          .describedAs("Rate of turn at 100 %, as the actuators have it.");

  static final Variable<Double> CRUISE_SPEED =
      Variable.number("CRUISE SPEED", "m/s")
          .range(Range.of(0.01, 100.0))
          .ifAbsent(2.0)
          .describedAs("Speed to a navigation point that says none.");

  static final Variable<Double> APPROACH_GAIN =
      Variable.number("APPROACH GAIN", "1/s")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.8)
          .describedAs("Most speed for each metre that is left.");

  static final Variable<Double> TURN_GAIN =
      Variable.number("TURN GAIN", "1/s")
          .range(Range.of(0.0, 10.0))
          .ifAbsent(1.0)
          .describedAs("Rate of turn for each radian of the point's direction.");

  static final Variable<Double> FACING_DISTANCE =
      Variable.number("FACING DISTANCE", "m")
          .range(Range.of(0.0, 100.0))
          .ifAbsent(1.0)
          .describedAs("Nearer points are not turned to: their direction is mostly error.");

  static final Variable<Boolean> SIDEWAYS =
      Variable.flag("SIDEWAYS")
          .ifAbsent(true)
          .describedAs("Whether the vehicle can go sideways and backwards, as a multicopter.");

  /** Called by the launcher. */
  public VelocityControl(ServiceContext context) {
    super(context, "VelocityControl");
    getVariable(FULL_SPEED); // wrong values must fail before the drive
    getVariable(FULL_CLIMB);
    getVariable(FULL_TURN);
    getVariable(CRUISE_SPEED);
    getVariable(APPROACH_GAIN);
    getVariable(TURN_GAIN);
    getVariable(FACING_DISTANCE);
    getVariable(SIDEWAYS);
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<Point> way = point.flatMap(this::nedOf).flatMap(ned -> ahead(ned, state));
    if (way.isEmpty()) {
      neutral().forEach(this::command);
      return;
    }
    Point toGo = way.get(); // forward, left, up
    double distance = toGo.distance();
    double wanted = point.get().speed().orElse(getVariable(CRUISE_SPEED));
    double speed = Math.min(wanted, getVariable(APPROACH_GAIN) * distance);
    double perMetre = distance > 0.0 ? speed / distance : 0.0;
    boolean sideways = getVariable(SIDEWAYS);
    double forward = sideways ? toGo.x() : Math.max(0.0, toGo.x());
    command(FORWARD, percent(forward * perMetre, FULL_SPEED));
    command(LEFT, sideways ? percent(toGo.y() * perMetre, FULL_SPEED) : 0.0);
    command(CLIMB, percent(toGo.z() * perMetre, FULL_CLIMB));
    boolean faces = Math.hypot(toGo.x(), toGo.y()) >= getVariable(FACING_DISTANCE);
    double turn = faces ? getVariable(TURN_GAIN) * toGo.azimuth() : 0.0;
    command(TURN, percent(turn, FULL_TURN));
  }

  private double percent(double value, Variable<Double> full) {
    return FULL_PERCENT * value / getVariable(full);
  }

  /**
   * A way by north, east, down as forward, left, up of the level vehicle [m]; empty without a
   * heading.
   */
  private static Optional<Point> ahead(Point ned, StateInformation state) {
    boolean local = state.referenceFrame().isLocal();
    StateInformation turned = state.in(local ? ReferenceFrame.LOCAL_NED : ReferenceFrame.GLOBAL);
    if (turned.psi().isEmpty()) {
      return Optional.empty();
    }
    Point level = new Attitude(0.0, 0.0, turned.psi().getAsDouble()).levelOf(ned);
    return Optional.of(Point.of(level.x(), level.y(), -level.z()));
  }

  @Override
  protected Map<String, Double> neutral() {
    Map<String, Double> neutral = new LinkedHashMap<>();
    neutral.put(FORWARD, 0.0);
    neutral.put(LEFT, 0.0);
    neutral.put(CLIMB, 0.0);
    neutral.put(TURN, 0.0);
    return neutral;
  }
}
