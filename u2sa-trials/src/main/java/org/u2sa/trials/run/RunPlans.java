package org.u2sa.trials.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.Home;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.sim.world.LocalPlane;

/** Converts missions to plans for reports and screens. */
public final class RunPlans {
  private RunPlans() {}

  /**
   * The plan of a mission in earth coordinates.
   *
   * @param home where the vehicle starts
   * @throws BadInputException if a waypoint is not in earth coordinates
   */
  static RunPlan of(Domain domain, Mission mission, Optional<RunPlan.Start> home) {
    List<RunPlan.Waypoint> waypoints = new ArrayList<>();
    List<RunPlan.OtherGoal> others = new ArrayList<>();
    for (int i = 0; i < mission.goals().size(); i++) {
      GoalInformation goal = mission.goals().get(i);
      if (goal instanceof Waypoint waypoint) {
        StateInformation place = onEarth(mission, i, waypoint);
        waypoints.add(
            new RunPlan.Waypoint(
                waypoint.uid(),
                place.x().orElseThrow(),
                place.y().orElseThrow(),
                waypoint.z(),
                waypoint.horizontalThreshold(),
                waypoint.verticalThreshold()));
      } else {
        others.add(new RunPlan.OtherGoal(goal.uid(), waypoints.size()));
      }
    }
    return new RunPlan(domain, home, waypoints).with(others);
  }

  /**
   * The plan of any mission: waypoints on the earth or in a local frame. Payload drops are omitted:
   * an aeroplane releases the payload far before the place where it must land.
   *
   * @param local plane at the origin of the local frames
   */
  public static RunPlan placed(
      Domain domain, Mission mission, RunPlan.Start home, LocalPlane local) {
    List<RunPlan.Waypoint> waypoints = new ArrayList<>();
    List<RunPlan.OtherGoal> others = new ArrayList<>();
    for (GoalInformation goal : mission.goals()) {
      Optional<RunPlan.Waypoint> placed =
          goal instanceof Waypoint waypoint && !(goal instanceof PayloadDrop)
              ? waypoint(waypoint, local.origin())
              : Optional.empty();
      placed.ifPresent(waypoints::add);
      if (!(goal instanceof Waypoint)) {
        others.add(new RunPlan.OtherGoal(goal.uid(), waypoints.size()));
      }
    }
    return new RunPlan(domain, Optional.of(home), waypoints).with(others);
  }

  /**
   * A goal as a waypoint of a plan; empty if it has no position on the earth or in a local frame.
   *
   * @param origin of the local frames
   */
  static Optional<RunPlan.Waypoint> waypoint(Waypoint goal, Geodetic origin) {
    if (goal.x().isEmpty() || goal.y().isEmpty()) {
      return Optional.empty();
    }
    return place(goal, origin)
        .map(
            place ->
                new RunPlan.Waypoint(
                    goal.uid(),
                    place.x().orElseThrow(),
                    place.y().orElseThrow(),
                    goal.z().isPresent() ? place.z() : OptionalDouble.empty(),
                    goal.horizontalThreshold(),
                    goal.verticalThreshold()));
  }

  /**
   * A plan whose stations are reached on the circles around them.
   *
   * @param loiterM radius of the circle around a station without one [m]; 0 for a vehicle that does
   *     not circle
   */
  static RunPlan circled(RunPlan plan, Mission mission, double loiterM) {
    Map<String, Double> radii = new HashMap<>();
    for (GoalInformation goal : mission.goals()) {
      if (loiterM > 0.0 && goal instanceof Station station) {
        double given = Math.abs(station.radius().orElse(0.0));
        radii.put(goal.uid(), given == 0.0 ? loiterM : given);
      }
    }
    return plan.reachedWithin(
        waypoint -> waypoint.captureRadiusM() + radii.getOrDefault(waypoint.name(), 0.0));
  }

  private static Optional<StateInformation> place(Waypoint waypoint, Geodetic origin) {
    StateInformation at =
        new StateInformation()
            .referenceFrame(waypoint.referenceFrame())
            .x(waypoint.x().orElseThrow())
            .y(waypoint.y().orElseThrow());
    waypoint.z().ifPresent(at::z);
    try {
      return Optional.of(at.in(ReferenceFrame.GLOBAL, origin));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // relative to the vehicle or another moving object
    }
  }

  /**
   * Initial position of a mission's vehicle.
   *
   * @throws BadInputException if the mission has no home in earth coordinates
   */
  static Home home(Mission mission) {
    return mission
        .home()
        .filter(home -> home.geodetic().isPresent())
        .orElseThrow(
            () ->
                new BadInputException(
                    mission.origin()
                        + ": has no home in Global, which is the vehicle's starting position"));
  }

  /** Likewise, for reports. */
  public static RunPlan.Start start(Mission mission) {
    Home home = home(mission);
    Geodetic place = home.geodetic().orElseThrow();
    return new RunPlan.Start(
        place.longitudeDeg(),
        place.latitudeDeg(),
        place.altitudeM(),
        home.headingRad().orElse(0.0));
  }

  /** The waypoint's longitude and latitude [deg]. */
  private static StateInformation onEarth(Mission mission, int index, Waypoint waypoint) {
    if (!waypoint.referenceFrame().isEarth() || waypoint.x().isEmpty() || waypoint.y().isEmpty()) {
      throw mission.goalError(
          index,
          "goal \""
              + waypoint.uid()
              + "\" is not a position on the earth; expected <x> and <y> in longitude and "
              + "latitude, or UTM");
    }
    return new StateInformation()
        .referenceFrame(waypoint.referenceFrame())
        .x(waypoint.x().getAsDouble())
        .y(waypoint.y().getAsDouble())
        .in(ReferenceFrame.GLOBAL);
  }
}
