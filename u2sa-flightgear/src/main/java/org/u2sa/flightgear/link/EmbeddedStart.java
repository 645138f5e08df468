package org.u2sa.flightgear.link;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.mission.Home;
import org.u2sa.mission.Mission;
import org.u2sa.sim.aircraft.RunwayStart;

/** Starting position of the embedded aircraft. */
public final class EmbeddedStart {
  private EmbeddedStart() {}

  /**
   * Returns the mission's home as a runway position.
   *
   * @throws BadInputException if the mission has no home, or the home lacks a coordinate or heading
   */
  public static RunwayStart of(Mission mission) {
    Home home = mission.home().orElseThrow(() -> lacks(mission, "a <home>"));
    Geodetic place =
        home.geodetic().orElseThrow(() -> lacks(mission, "a <home> in longitude and latitude"));
    home.z().orElseThrow(() -> lacks(mission, "the altitude <z> of its <home>"));
    double heading =
        home.headingRad().orElseThrow(() -> lacks(mission, "the heading <psi> of its <home>"));
    requireWithin(
        mission,
        "y",
        place.latitudeDeg(),
        -RunwayStart.NORTHERNMOST_DEG,
        RunwayStart.NORTHERNMOST_DEG,
        "deg of latitude, the range for starting: nearer to a pole headings change too fast");
    requireWithin(
        mission,
        "z",
        place.altitudeM(),
        RunwayStart.LOWEST_M,
        RunwayStart.HIGHEST_M,
        "m above sea level, the range for starting");
    return new RunwayStart(place.longitudeDeg(), place.latitudeDeg(), place.altitudeM(), heading);
  }

  private static void requireWithin(
      Mission mission, String child, double value, double least, double most, String what) {
    if (value < least || value > most) {
      throw mission.homeError(child, value + " is outside " + least + "…" + most + " " + what);
    }
  }

  private static BadInputException lacks(Mission mission, String what) {
    return new BadInputException(
        mission.origin() + ": lacks " + what + ", where the aircraft stands before take-off");
  }
}
