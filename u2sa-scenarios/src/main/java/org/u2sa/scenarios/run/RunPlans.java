package org.u2sa.scenarios.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.Home;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;

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
      }
    }
    return new RunPlan(domain, home, waypoints);
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
                        + ": has no home in Global; expected one, where the vehicle stands at first"));
  }

  /** The same for reports. */
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
              + "\" is no place on the earth; expected <x> and <y> in longitude and latitude, or UTM");
    }
    return new StateInformation()
        .referenceFrame(waypoint.referenceFrame())
        .x(waypoint.x().getAsDouble())
        .y(waypoint.y().getAsDouble())
        .in(ReferenceFrame.GLOBAL);
  }
}
