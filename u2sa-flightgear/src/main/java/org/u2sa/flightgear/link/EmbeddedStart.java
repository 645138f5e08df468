package org.u2sa.flightgear.link;

import org.u2sa.core.mission.Home;
import org.u2sa.core.mission.Mission;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.aircraft.RunwayStart;

/** Where the aircraft stands when a mission begins. */
public final class EmbeddedStart {
  private EmbeddedStart() {}

  /**
   * The mission's home.
   *
   * @throws BadInputException if it has none, or not all that an aircraft needs
   */
  public static RunwayStart of(Mission mission) {
    Home home = mission.home().orElseThrow(() -> lacks(mission, "a <home>"));
    Geodetic place =
        home.geodetic().orElseThrow(() -> lacks(mission, "a <home> in longitude and latitude"));
    home.z().orElseThrow(() -> lacks(mission, "the altitude <z> of its <home>"));
    double heading =
        home.headingRad().orElseThrow(() -> lacks(mission, "the heading <psi> of its <home>"));
    return new RunwayStart(place.longitudeDeg(), place.latitudeDeg(), place.altitudeM(), heading);
  }

  private static BadInputException lacks(Mission mission, String what) {
    return new BadInputException(
        mission.origin() + ": lacks " + what + ", where the aircraft stands before take-off");
  }
}
