package org.u2sa.scenarios.cessna;

import java.util.Locale;
import java.util.SplittableRandom;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Missions that nobody tuned anything for, but that a Cessna 172 can fly: a seed gives an airfield,
 * ten waypoints and altitudes.
 *
 * <p>Legs are at least 1.5 km long, and longer after a sharp turn; altitudes are 300…2500 m above
 * sea level and at least 150 m above the field; no leg asks for more than 2 m/s of climb or
 * descent, and the first leaves room for the take-off.
 */
final class RandomMission {
  private static final int WAYPOINTS = 10;
  private static final double SHORTEST_LEG_M = 1_500.0;
  private static final double LONGER_AFTER_HALF_TURN_M = 2_500.0; // a U-turn is 1.2 km wide
  private static final double SPREAD_M = 3_000.0;
  private static final double SHARPEST_TURN_DEG = 175.0;
  private static final double LOWEST_M = 300.0;
  private static final double HIGHEST_M = 2_500.0;
  private static final double CLEARANCE_M = 150.0;
  private static final double CLIMB_MPS = 2.0;
  private static final double FAST_MPS = 60.0; // over ground: cruise in thin air, wind behind
  private static final double TAKE_OFF_M = 2_000.0; // until it climbs steadily

  private final SplittableRandom random;
  private final Airfield field;
  private final StringBuilder xml = new StringBuilder();
  private Geodetic place;
  private double courseDeg;

  private RandomMission(long seed) {
    random = new SplittableRandom(seed);
    field = Airfield.values()[(int) (seed % Airfield.values().length)];
    place = field.place();
    courseDeg = field.headingDeg();
  }

  /** The mission of a seed, as the text of a mission file. */
  static String ofSeed(long seed) {
    return new RandomMission(seed).text();
  }

  private String text() {
    append(
        "<mission>%n  <home><x>%.6f</x><y>%.6f</y><z>%.1f</z><psi>%.1f</psi></home>%n",
        place.longitudeDeg(), place.latitudeDeg(), place.altitudeM(), courseDeg);
    firstWaypoint();
    for (int k = 2; k <= WAYPOINTS; k++) {
      double turnDeg = SHARPEST_TURN_DEG * (2.0 * random.nextDouble() - 1.0);
      double lengthM =
          SHORTEST_LEG_M
              + LONGER_AFTER_HALF_TURN_M * Math.abs(turnDeg) / 180.0
              + SPREAD_M * random.nextDouble();
      courseDeg += turnDeg;
      waypoint(k, lengthM, altitude(lengthM));
    }
    return xml.append("</mission>\n").toString();
  }

  private void firstWaypoint() {
    courseDeg += 60.0 * random.nextDouble() - 30.0;
    double lowest = Math.max(LOWEST_M, place.altitudeM() + CLEARANCE_M);
    double climb = lowest - place.altitudeM() + 100.0 * random.nextDouble();
    double lengthM = TAKE_OFF_M + climb * FAST_MPS / CLIMB_MPS;
    waypoint(1, lengthM, place.altitudeM() + climb);
  }

  /** Half of all legs are level, the others climb or descend towards any altitude. */
  private double altitude(double lengthM) {
    if (random.nextBoolean()) {
      return place.altitudeM();
    }
    double change = CLIMB_MPS * lengthM / FAST_MPS;
    double lowest = Math.max(LOWEST_M, field.place().altitudeM() + CLEARANCE_M);
    double wanted = lowest + (HIGHEST_M - lowest) * random.nextDouble();
    return Math.max(place.altitudeM() - change, Math.min(place.altitudeM() + change, wanted));
  }

  private void waypoint(int number, double lengthM, double altitudeM) {
    double course = Math.toRadians(courseDeg);
    Geodetic reached =
        place.fromEnu(Point.of(lengthM * Math.sin(course), lengthM * Math.cos(course), 0.0));
    place = new Geodetic(reached.longitudeDeg(), reached.latitudeDeg(), altitudeM);
    append(
        "  <waypoint><name>%d</name><x>%.6f</x><y>%.6f</y><z>%.1f</z><horizontalThreshold>100</horizontalThreshold></waypoint>%n",
        number, place.longitudeDeg(), place.latitudeDeg(), altitudeM);
  }

  private void append(String format, Object... values) {
    xml.append(String.format(Locale.ROOT, format, values));
  }
}
