package org.u2sa.scenarios.encounters;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.u2sa.planning.rightofway.Rule;

/**
 * A published encounter with one to three vessels, scaled to a small boat: its speed becomes {@link
 * #OWN_MPS} and time passes {@link #FASTER} times as fast, so lengths scale by the ratio of the
 * speeds divided by that factor. The boat starts at the origin, northbound. Immutable.
 *
 * @param name such as {@code dnv-07}
 * @param vessels the others
 */
record EncounterCase(String name, List<Vessel> vessels) {
  /** Speed of the boat [m/s]. */
  static final double OWN_MPS = 1.5;

  /** Minutes of the original take ten seconds. */
  static final double FASTER = 6.0;

  private static final double DOUBT_RAD = Math.toRadians(5.0);
  private static final double MIN_RANGE_M = 60.0;
  private static final String RESOURCE = "cases.csv";
  private static final double MPS_PER_KN = 1852.0 / 3600.0;
  private static final double DNV_KN = 10.0;
  private static final double IMAZU_KN = 12.0;
  private static final int FIELDS = 7;

  /**
   * Another vessel, which never changes its course and speed.
   *
   * @param uid name
   * @param northM north of the boat's start [m]
   * @param eastM east of the boat's start [m]
   * @param courseRad clockwise from north [rad]
   * @param speedMps speed [m/s]
   * @param expected the rule for the boat, or those possible within the accuracy of courses
   */
  record Vessel(
      String uid,
      double northM,
      double eastM,
      double courseRad,
      double speedMps,
      Set<Rule> expected) {
    double northMps() {
      return speedMps * Math.cos(courseRad);
    }

    double eastMps() {
      return speedMps * Math.sin(courseRad);
    }

    double northAtM(double timeS) {
      return northM + northMps() * timeS;
    }

    double eastAtM(double timeS) {
      return eastM + eastMps() * timeS;
    }

    /** Time of the closest point of approach if the boat does nothing [s]. */
    double closestS() {
      double north = northMps() - OWN_MPS;
      double east = eastMps();
      return -(northM * north + eastM * east) / (north * north + east * east);
    }

    private Vessel changed(Random random) {
      double speed = speedMps * (1.0 + 0.2 * (2.0 * random.nextDouble() - 1.0));
      double course = courseRad + Math.toRadians(10.0) * (2.0 * random.nextDouble() - 1.0);
      double time = closestS();
      double north = (OWN_MPS - speed * Math.cos(course)) * time;
      double east = -speed * Math.sin(course) * time;
      return new Vessel(uid, north, east, course, speed, expectedRules(north, east, course));
    }
  }

  /** All published cases. */
  static List<EncounterCase> all() {
    Map<String, List<Vessel>> cases = new LinkedHashMap<>();
    try (InputStream in = EncounterCase.class.getResourceAsStream(RESOURCE);
        BufferedReader lines =
            new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
      lines
          .lines()
          .filter(line -> !line.startsWith("#"))
          .forEach(
              line -> {
                String[] fields = line.split(",");
                if (fields.length != FIELDS) {
                  throw new IllegalStateException(line + ": expected " + FIELDS + " fields");
                }
                cases.computeIfAbsent(fields[0], key -> new ArrayList<>()).add(scaled(fields));
              });
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    List<EncounterCase> all = new ArrayList<>();
    cases.forEach((name, vessels) -> all.add(new EncounterCase(name, List.copyOf(vessels))));
    return all;
  }

  private static Vessel scaled(String[] fields) {
    double speed = OWN_MPS / (fields[0].startsWith("dnv") ? DNV_KN : IMAZU_KN);
    double length = speed / MPS_PER_KN / FASTER;
    return new Vessel(
        "vessel " + fields[1],
        length * Double.parseDouble(fields[2]),
        length * Double.parseDouble(fields[3]),
        Math.toRadians(Double.parseDouble(fields[4])),
        speed * Double.parseDouble(fields[5]),
        Set.of(Rule.valueOf(fields[6])));
  }

  /** Latest closest point of approach if the boat does nothing [s]. */
  double lastClosestS() {
    return vessels.stream().mapToDouble(Vessel::closestS).max().orElse(0.0);
  }

  /**
   * A variation: speeds ±20 % and bearings ±10°, such that each vessel still meets the boat at the
   * original time and starts at least {@link #MIN_RANGE_M} away. The expected rules are those of
   * the sectors within 5°.
   */
  EncounterCase varied(long seed) {
    Random random = new Random(seed);
    List<Vessel> others = new ArrayList<>();
    for (Vessel each : vessels) {
      Vessel other = each.changed(random);
      while (Math.hypot(other.northM, other.eastM) < MIN_RANGE_M) {
        other = each.changed(random);
      }
      others.add(other);
    }
    return new EncounterCase(name + "/" + seed, List.copyOf(others));
  }

  private static Set<Rule> expectedRules(double northM, double eastM, double courseRad) {
    double bearing = Math.atan2(eastM, northM);
    double aspect = bearing + Math.PI - courseRad;
    Set<Rule> rules = EnumSet.noneOf(Rule.class);
    for (double doubt : new double[] {0.0, DOUBT_RAD}) {
      for (double off : new double[] {-DOUBT_RAD, 0.0, DOUBT_RAD}) {
        rules.add(Rule.of(bearing + off, aspect, doubt));
        rules.add(Rule.of(bearing, aspect + off, doubt));
      }
    }
    return rules;
  }
}
