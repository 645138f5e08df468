package org.u2sa.control.fixedwing;

import java.util.Map;
import java.util.Optional;
import org.u2sa.control.ControlSystem;
import org.u2sa.control.LandingGoals;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Control of the thesis's Cessna (4.5.2.5), kept for teaching. In: state, navigation, goals. Out:
 * actuation, goal-reports (of landings, which it cannot fly). It keeps an aircraft airborne and
 * flies it past waypoints in calm air; airspeed, wind, stall and runway are not considered; for
 * those see {@link CessnaControl}. Without fresh navigation it sends no commands, and actuators go
 * neutral when their commands expire.
 */
public final class ThesisControl extends ControlSystem {
  private static final double FULL_PERCENT = 100.0;

  private final FlightStateReader reader = new FlightStateReader();
  private final LandingGoals landings = new LandingGoals();
  private final ThesisLaw law;

  public ThesisControl(ServiceContext context) {
    super(context, "Control");
    law = new ThesisLaw(settings(ThesisLaw.Variables.class).get());
    subscribe(Channels.GOALS, goals -> landings.see(goals, clock().micros()));
    registerPublisher(Channels.GOAL_REPORTS);
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<FlightState> seen = reader.read(state);
    Optional<Point> ned = point.flatMap(this::nedOf);
    landings
        .refused(Optional.of("it does not flare"), clock().micros())
        .ifPresent(report -> publish(Channels.GOAL_REPORTS, report));
    if (seen.isEmpty() || ned.isEmpty()) {
      return;
    }
    Point ahead = ned.get();
    FlightState now = seen.get();
    GuidanceTarget target =
        new GuidanceTarget(
            ahead.x(), ahead.y(), now.altitudeM() - ahead.z(), point.orElseThrow().speed());
    Surfaces surfaces = law.surfaces(now, target);
    for (AircraftActuator actuator : AircraftActuator.values()) {
      command(actuator.actuatorName(), FULL_PERCENT * actuator.of(surfaces));
    }
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    reader.handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    reader.takeOver(state);
  }

  @Override
  protected Map<String, Double> neutral() {
    return AircraftActuator.neutral();
  }

  /**
   * The proportional controllers of thesis 4.5.2.4 and 4.5.2.5: bearing drives the aileron, the
   * altitude differential the elevator. Two damping terms not in the thesis suppress bank
   * oscillation and pitch hunting; with their gains at 0 this is the law of the thesis.
   */
  static final class ThesisLaw {
    /** With BANK GAIN and PITCH GAIN at 0, this is the law of the thesis. */
    record Variables(
        @Variable(min = 0, max = 5, ifAbsent = 1)
            @Description("Fraction of full aileron for a bearing of 180 degrees; thesis: 1.")
            double directionGain,
        @Variable(unit = "deg", min = 1, max = 180, ifAbsent = 30)
            @Description("Bearing beyond which the aileron moves no further; thesis: 180.")
            double directionLimit,
        @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 0.4)
            @Description("Aileron per bank, to damp it; thesis: 0.")
            double bankGain,
        @Variable(min = 0, max = 1, ifAbsent = 0.3)
            @Description("Fraction of full elevator at an altitude difference of 1000 ft or more.")
            double altitudeGain,
        @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 1.5)
            @Description("Elevator per pitch, to damp it; thesis: 0.")
            double pitchGain,
        @Variable(unit = "deg", min = -5, max = 15, ifAbsent = 6)
            @Description("Pitch in level flight.")
            double levelPitch,
        @Variable(min = 0.1, max = 1, ifAbsent = 0.6) @Description("Throttle of level flight.")
            double cruiseThrottle) {}

    private static final double FULL_DIFFERENTIAL_M = 1_000.0 * 0.3048; // 4.5.2.4: full climb
    private static final double MIN_DIFFERENTIAL_M = 10.0 * 0.3048; // 4.5.2.4: hold altitude

    private final Variables parameters;

    ThesisLaw(Variables parameters) {
      this.parameters = parameters;
    }

    Surfaces surfaces(FlightState state, GuidanceTarget target) {
      double bearing = StrictMath.atan2(target.eastM(), target.northM());
      double direction = Limit.angle(bearing - state.headingRad());
      double climb = differential(target.altitudeM() - state.altitudeM());
      double limit = Math.toRadians(parameters.directionLimit());
      double limited = Limit.symmetric(direction, limit);
      double aileron =
          parameters.directionGain() * limited / Math.PI - parameters.bankGain() * state.rollRad();
      double elevator =
          -parameters.altitudeGain() * climb
              + parameters.pitchGain()
                  * (state.pitchRad() - Math.toRadians(parameters.levelPitch()));
      double cruise = parameters.cruiseThrottle();
      double throttle = cruise + climb * (climb > 0.0 ? 1.0 - cruise : cruise);
      double rudder = state.onGround() ? limited / limit : 0.0;
      return new Surfaces(
          Limit.symmetric(aileron, 1.0),
          Limit.symmetric(elevator, 1.0),
          rudder,
          Limit.within(0.0, throttle, 1.0),
          1.0,
          0.0,
          0.0);
    }

    /** Altitude differential scaled to −1…1: 0 below 10 ft, full from 1000 ft (4.5.2.4). */
    static double differential(double metres) {
      double beyond = Math.abs(metres) - MIN_DIFFERENTIAL_M;
      double share = beyond / (FULL_DIFFERENTIAL_M - MIN_DIFFERENTIAL_M);
      return Math.copySign(Limit.within(0.0, share, 1.0), metres);
    }
  }
}
