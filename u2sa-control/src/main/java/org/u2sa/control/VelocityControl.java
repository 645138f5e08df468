package org.u2sa.control;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;

/**
 * Controls a vehicle that regulates its own velocity, such as one with an ArduPilot or PX4
 * autopilot: converts the vector to the navigation point to speeds along the vehicle's axes and a
 * turn rate; near the point, to the turn wanted there. In: navigation, state. Out: actuation of
 * FORWARD SPEED, LEFT SPEED, CLIMB SPEED and TURN RATE.
 *
 * <p>Without fresh navigation all four are 0 and the vehicle stops.
 */
public final class VelocityControl extends ControlSystem {
  static final String FORWARD = "FORWARD SPEED";
  static final String LEFT = "LEFT SPEED";
  static final String CLIMB = "CLIMB SPEED";
  static final String TURN = "TURN RATE";

  private static final double FULL_PERCENT = 100.0;

  private record Variables(
      @Variable(unit = "m/s", min = 0.01, max = 100, ifAbsent = 5)
          @Description("Forward and sideways speed at 100 %, as set for the actuators.")
          double fullSpeed,
      @Variable(unit = "m/s", min = 0.01, max = 50, ifAbsent = 2)
          @Description("Climb speed at 100 %, as set for the actuators.")
          double fullClimb,
      @Variable(unit = "rad/s", min = 0.01, max = 10, ifAbsent = 1)
          @Description("Turn rate at 100 %, as set for the actuators.")
          double fullTurn,
      @Variable(unit = "m/s", min = 0.01, max = 100, ifAbsent = 2)
          @Description("Speed towards a navigation point that does not specify one.")
          double cruiseSpeed,
      @Variable(unit = "1/s", min = 0.01, max = 10, ifAbsent = 0.8)
          @Description("Maximum speed per metre of remaining distance.")
          double approachGain,
      @Variable(unit = "1/s", min = 0, max = 10, ifAbsent = 1)
          @Description("Turn rate per bearing error.")
          double turnGain,
      @Variable(unit = "m", min = 0, max = 100, ifAbsent = 1)
          @Description(
              "Minimum distance of a point to turn towards: the bearing of a nearer point is mostly error.")
          double facingDistance,
      @Variable(ifAbsentText = "true")
          @Description("Whether the vehicle can move sideways and backwards, like a multicopter.")
          boolean sideways) {}

  private final Settings<Variables> tuning = settings(Variables.class);

  public VelocityControl(ServiceContext context) {
    super(context, "VelocityControl");
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<Point> way = point.flatMap(this::nedOf).flatMap(ned -> ahead(ned, state));
    if (way.isEmpty()) {
      neutral().forEach(this::command);
      return;
    }
    Variables now = tuning.get();
    Point toGo = way.get(); // forward, left, up
    double distance = toGo.distance();
    double wanted = point.get().speed().orElse(now.cruiseSpeed());
    double speed = Math.min(wanted, now.approachGain() * distance);
    double perMetre = distance > 0.0 ? speed / distance : 0.0;
    double forward = now.sideways() ? toGo.x() : Math.max(0.0, toGo.x());
    double left = now.sideways() ? toGo.y() : 0.0;
    double forwardPercent = percent(forward * perMetre, now.fullSpeed());
    double leftPercent = percent(left * perMetre, now.fullSpeed());
    double climbPercent = percent(toGo.z() * perMetre, now.fullClimb());
    double most = Math.max(Math.abs(forwardPercent), Math.abs(leftPercent));
    most = Math.max(FULL_PERCENT, Math.max(most, Math.abs(climbPercent)));
    double share = FULL_PERCENT / most; // clamping each axis would change the direction
    command(FORWARD, share * forwardPercent);
    command(LEFT, share * leftPercent);
    command(CLIMB, share * climbPercent);
    boolean faces = Math.hypot(toGo.x(), toGo.y()) >= now.facingDistance();
    double turn = now.turnGain() * (faces ? toGo.azimuth() : leftRad(point.get(), state));
    command(TURN, percent(turn, now.fullTurn()));
  }

  /** Remainder of the turn wanted at a point [rad], left positive; 0 if any heading will do. */
  private double leftRad(NavigationPoint point, StateInformation now) {
    OptionalDouble then = stateOf(point).map(StateInformation::psi).orElse(OptionalDouble.empty());
    if (point.turn().isEmpty() || then.isEmpty()) {
      return 0.0;
    }
    double wanted = then.getAsDouble() + point.turn().getAsDouble();
    return Math.IEEEremainder(now.psi().orElseThrow() - wanted, 2.0 * Math.PI);
  }

  private static double percent(double value, double full) {
    return FULL_PERCENT * value / full;
  }

  /**
   * Rotates north, east, down to forward, left, up of the level vehicle [m]; empty without a
   * heading.
   */
  private static Optional<Point> ahead(Point ned, StateInformation state) {
    if (state.psi().isEmpty()) {
      return Optional.empty();
    }
    Point level = new Attitude(0.0, 0.0, state.psi().getAsDouble()).levelOf(ned);
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
