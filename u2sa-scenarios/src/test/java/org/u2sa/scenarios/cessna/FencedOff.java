package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.cessna.FlightWitness.Moment;

/**
 * A geofence that cuts off a leg of the mission, somewhere and at some angle: a long straight side,
 * and far away from it three more. East and north of home [m].
 */
record FencedOff(double atEastM, double atNorthM, double outEast, double outNorth) {
  private static final double FAR_M = 30_000.0;

  /** Waypoints 1 to 4 of missions/cessna/mission.xml, in which each leg leads on from home. */
  private static final List<Geodetic> ROUTE =
      List.of(
          new Geodetic(-157.890168, 21.325239, 0.0),
          new Geodetic(-157.897698, 21.285214, 0.0),
          new Geodetic(-157.887724, 21.250318, 0.0),
          new Geodetic(-157.839553, 21.250311, 0.0));

  private static final double ROOM_AT_HOME_M = 3_000.0;
  private static final double ROOM_M = 2_000.0;
  private static final double BEYOND_M = 100.0;

  /**
   * The side goes through a point of a leg, up to 60° from across it; what is flown before lies
   * well inside.
   */
  static FencedOff ofSeed(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    FencedOff fence;
    int leg;
    do {
      leg = random.nextInt(ROUTE.size() - 1);
      fence = across(leg, random);
    } while (!fence.leavesRoomUpTo(leg));
    return fence;
  }

  private boolean leavesRoomUpTo(int leg) {
    boolean room = marginM(0.0, 0.0) > ROOM_AT_HOME_M;
    for (int i = 0; i <= leg; i++) {
      Point corner = TroubledFlight.HOME.enuOf(ROUTE.get(i));
      room &= marginM(corner.x(), corner.y()) > ROOM_M;
    }
    Point end = TroubledFlight.HOME.enuOf(ROUTE.get(leg + 1));
    return room && marginM(end.x(), end.y()) < -BEYOND_M;
  }

  private static FencedOff across(int leg, SplittableRandom random) {
    Point from = TroubledFlight.HOME.enuOf(ROUTE.get(leg));
    Point to = TroubledFlight.HOME.enuOf(ROUTE.get(leg + 1));
    double share = 0.6 + 0.35 * random.nextDouble();
    double slant = Math.toRadians(60.0) * (2.0 * random.nextDouble() - 1.0);
    double out = Math.atan2(to.x() - from.x(), to.y() - from.y()) + slant;
    return new FencedOff(
        from.x() + share * (to.x() - from.x()),
        from.y() + share * (to.y() - from.y()),
        Math.sin(out),
        Math.cos(out));
  }

  /** Distance from the side, positive inside [m]. */
  double marginM(Moment moment) {
    return marginM(moment.eastM(), moment.northM());
  }

  private double marginM(double eastM, double northM) {
    return (atEastM - eastM) * outEast + (atNorthM - northM) * outNorth;
  }

  /** Writes it down as a fence file. */
  Path in(Path directory) {
    StringBuilder text = new StringBuilder("<fence><keepIn>");
    for (double[] corner : new double[][] {{0, 1}, {-2, 1}, {-2, -1}, {0, -1}}) {
      double east = atEastM + FAR_M * (corner[0] * outEast + corner[1] * outNorth);
      double north = atNorthM + FAR_M * (corner[0] * outNorth - corner[1] * outEast);
      Geodetic place = TroubledFlight.HOME.fromEnu(Point.of(east, north, 0.0));
      text.append(
          String.format(
              Locale.ROOT,
              "<corner><x>%.7f</x><y>%.7f</y></corner>",
              place.longitudeDeg(),
              place.latitudeDeg()));
    }
    try {
      return Files.writeString(
          directory.resolve("fence.xml"), text.append("</keepIn></fence>").toString());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
