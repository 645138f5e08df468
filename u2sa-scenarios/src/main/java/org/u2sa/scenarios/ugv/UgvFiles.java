package org.u2sa.scenarios.ugv;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.core.mission.Home;
import org.u2sa.core.mission.Mission;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.scenarios.report.Domain;
import org.u2sa.scenarios.report.RunPlan;
import org.u2sa.scenarios.run.HomeFolder;
import org.u2sa.scenarios.run.RunPlans;

/** Where the ground vehicle's files lie, and how its missions are judged. */
final class UgvFiles {
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
    return RunPlans.of(
        Domain.GROUND,
        mission,
        Optional.of(
            new org.u2sa.scenarios.report.StartPlace(
                place.longitudeDeg(),
                place.latitudeDeg(),
                place.altitudeM(),
                start.headingRad().orElse(0.0),
                OptionalDouble.empty())));
  }
}
