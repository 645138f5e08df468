package org.u2sa.gcs.ugv;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.core.mission.Home;
import org.u2sa.core.mission.Mission;
import org.u2sa.gcs.demo.HomeFolder;
import org.u2sa.gcs.demo.RunPlans;
import org.u2sa.gcs.report.Domain;
import org.u2sa.gcs.report.PlannedWaypoint;
import org.u2sa.gcs.report.RunPlan;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;

/** Where the ground vehicle's files lie, and how its missions are judged. */
final class UgvFiles {
  /**
   * A waypoint counts as reached within this distance of truth [m], as in IGVC's qualification,
   * also where the mission has the vehicle turn to the next one later than that.
   */
  static final double CAPTURE_RADIUS_M = 2.0;

  private UgvFiles() {}

  /** The folder that holds {@code config} and {@code missions}. */
  static Path root() {
    return HomeFolder.holding("config/ugv");
  }

  /**
   * Where the vehicle stands at first: the mission's home.
   *
   * @throws BadInputException if it has none on the earth
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

  /** A mission as reports and screens see it. */
  static RunPlan plan(Mission mission) {
    Home start = home(mission);
    Geodetic place = start.geodetic().orElseThrow();
    RunPlan plan =
        RunPlans.of(
            Domain.GROUND,
            mission,
            Optional.of(
                new org.u2sa.gcs.report.Home(
                    place.longitudeDeg(),
                    place.latitudeDeg(),
                    place.altitudeM(),
                    start.headingRad().orElse(0.0),
                    OptionalDouble.empty())));
    List<PlannedWaypoint> judged = new ArrayList<>();
    for (PlannedWaypoint waypoint : plan.waypoints()) {
      judged.add(
          new PlannedWaypoint(
              waypoint.name(),
              waypoint.longitudeDeg(),
              waypoint.latitudeDeg(),
              waypoint.altitudeM(),
              Math.max(CAPTURE_RADIUS_M, waypoint.captureRadiusM()),
              waypoint.verticalThresholdM()));
    }
    return new RunPlan(Domain.GROUND, plan.home(), judged);
  }
}
