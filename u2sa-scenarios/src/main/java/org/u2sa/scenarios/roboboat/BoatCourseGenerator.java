package org.u2sa.scenarios.roboboat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.roboboat.gate.Gate;

/**
 * Generates courses by the rules: gates 2.2 to 3 m wide, the speed gates 8 to 25 m apart, 10 to 15
 * gates in a winding channel, 4 to 7 m apart; wind up to 6 m/s, current up to 0.5 m/s, small waves.
 */
final class BoatCourseGenerator {
  private static final double NARROWEST_M = 2.2;
  private static final double WIDEST_M = 3.0;
  private static final double MAX_BEND_RAD = Math.toRadians(14.0);
  private static final double MAX_COURSE_RAD = Math.toRadians(60.0);
  private static final double MAX_WIND_MPS = 6.0;
  private static final double MAX_CURRENT_MPS = 0.5;
  private static final double MAX_WAVE_M = 0.12;
  private static final double END_M = 10.0; // distance of the blue buoy behind the last gate
  private static final double END_ASIDE_M = 1.5;

  private final Random random;
  private double north;
  private double east;
  private double headingRad;

  private BoatCourseGenerator(long seed) {
    random = new Random(seed * 0x9E3779B97F4A7C15L);
    random.nextLong(); // neighbouring seeds have similar first numbers
  }

  static BoatCourse course(long seed) {
    BoatCourseGenerator generator = new BoatCourseGenerator(seed);
    return generator.draw(seed);
  }

  private BoatCourse draw(long seed) {
    north = between(10.0, 14.0);
    List<Gate> speedGates = new ArrayList<>(List.of(gate()));
    advance(between(8.0, 25.0));
    speedGates.add(gate());
    advance(between(10.0, 15.0));
    List<Gate> channel = new ArrayList<>();
    int gates = 10 + random.nextInt(6);
    for (int i = 0; i < gates; i++) {
      channel.add(gate());
      double bend = between(-MAX_BEND_RAD, MAX_BEND_RAD);
      headingRad = Math.max(-MAX_COURSE_RAD, Math.min(MAX_COURSE_RAD, headingRad + bend));
      advance(between(4.0, 7.0));
    }
    Gate last = channel.get(channel.size() - 1);
    Point behind = last.beyond(END_M);
    Point way = last.way();
    Point end =
        Point.of(behind.x() - END_ASIDE_M * way.y(), behind.y() + END_ASIDE_M * way.x(), 0.0);
    BoatCourse.Weather weather = weather(seed);
    List<TaskSite> sites = TaskSites.around(end, Math.atan2(way.y(), way.x()), random);
    return new BoatCourse(
        Point.ORIGIN, 0.0, List.copyOf(speedGates), List.copyOf(channel), end, sites, weather);
  }

  private BoatCourse.Weather weather(long seed) {
    double current = between(0.0, MAX_CURRENT_MPS);
    double towards = between(-Math.PI, Math.PI);
    return new BoatCourse.Weather(
        between(0.0, MAX_WIND_MPS),
        between(-Math.PI, Math.PI),
        current * Math.sin(towards),
        current * Math.cos(towards),
        between(0.02, MAX_WAVE_M),
        between(1.5, 2.5),
        seed);
  }

  private double between(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  private void advance(double metres) {
    north += metres * Math.cos(headingRad);
    east += metres * Math.sin(headingRad);
  }

  private Gate gate() {
    double half = between(NARROWEST_M, WIDEST_M) / 2.0;
    double across = half * Math.cos(headingRad);
    double along = half * Math.sin(headingRad);
    return new Gate(
        Point.of(north + along, east - across, 0.0), Point.of(north - along, east + across, 0.0));
  }
}
