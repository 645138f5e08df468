package org.u2sa.control.fixedwing;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Waypoints of a flight, as metres north and east of the runway's start and above the sea. */
record Course(List<Mark> marks) {
  /** One waypoint [m]. */
  record Mark(double northM, double eastM, double altitudeM) {}

  /** Ten waypoints like missions/cessna/mission.xml: turns both ways, climbs and descents. */
  static Course ten() {
    double[][] marks = {
      {0, 5500, 274},
      {-4444, 4719, 457},
      {-8318, 5753, 457},
      {-8319, 10748, 671},
      {-12660, 8251, 671},
      {-12661, 3757, 853},
      {-14595, 1462, 853},
      {-10253, -1035, 610},
      {-8499, -4064, 457},
      {-5213, -1772, 457}
    };
    List<Mark> list = new ArrayList<>();
    for (double[] m : marks) {
      list.add(new Mark(m[0], m[1], m[2]));
    }
    return new Course(List.copyOf(list));
  }

  /** Ten waypoints that nobody tuned for: legs of 1.5–4 km, turns to 120°, steps to 25 m a km. */
  static Course random(long seed, double elevationM) {
    Random random = new Random(seed);
    List<Mark> list = new ArrayList<>();
    double north = 0.0;
    double east = 4000.0;
    double altitude = elevationM + 200.0 + 50.0 * random.nextDouble();
    double heading = Math.PI / 2;
    list.add(new Mark(north, east, altitude));
    for (int i = 1; i < 10; i++) {
      double leg = 1500.0 + 2500.0 * random.nextDouble();
      heading += Math.toRadians(240.0) * (random.nextDouble() - 0.5);
      north += leg * Math.cos(heading);
      east += leg * Math.sin(heading);
      if (random.nextDouble() < 0.6) {
        altitude += (random.nextDouble() - 0.4) * 0.08 * leg;
        altitude = Math.max(elevationM + 150.0, altitude);
      }
      list.add(new Mark(north, east, altitude));
    }
    return new Course(List.copyOf(list));
  }
}
