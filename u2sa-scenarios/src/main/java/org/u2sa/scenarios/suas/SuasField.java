package org.u2sa.scenarios.suas;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.report.score.Surroundings;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.sim.world.ScriptedMover;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/**
 * A field of the competition. Positions are east, north and up from the middle of the runway [m].
 *
 * @param runwayRad direction of take-off and landing, clockwise from north [rad]
 * @param boundary corners of the permitted area
 * @param floorM minimum height away from the runway
 * @param ceilingM maximum height
 * @param waypoints waypoints in order
 * @param pillars cylindrical obstacles on the ground
 * @param searchArea its corners
 * @param resolutionM ground resolution required there
 * @param targets targets in the search area
 * @param traffic other aircraft
 * @param windMps steady wind
 * @param windFromRad direction it blows from
 * @param drop target of the bottle
 * @param qnhPa air pressure at sea level [Pa]
 * @param seed seed of gusts
 * @param ground terrain heights; level at the runway and the drop
 */
record SuasField(
    double runwayRad,
    List<Point> boundary,
    double floorM,
    double ceilingM,
    List<Point> waypoints,
    List<Pillar> pillars,
    List<Point> searchArea,
    double resolutionM,
    List<SuasTarget> targets,
    List<Traffic> traffic,
    double windMps,
    double windFromRad,
    Point drop,
    double qnhPa,
    long seed,
    Terrain ground) {
  /** Site of the 2025 competition: St. Mary's County airport, Maryland. */
  static final Geodetic ORIGIN = new Geodetic(-76.55578, 38.31633, 43.3);

  /** Half the length of the runway [m]. */
  static final double RUNWAY_HALF_M = 200.0;

  /** Radius of the sphere around other aircraft that must not be entered [m]. */
  static final double SEPARATION_M = 50.0;

  private static final double BODY_M = 2.0; // radius of other aircraft
  private static final int CORNERS = 24; // number of corners of a pillar on the map

  /** A cylinder from the ground up [m]. */
  record Pillar(double eastM, double northM, double radiusM, double heightM) {}

  /** An aircraft with a transponder that flies to and fro. */
  record Traffic(String name, Point from, Point to, double speedMps) {}

  /**
   * The mission of 2025: the waypoints in laps, without a search area.
   *
   * @param laps number of times they are flown
   */
  SuasField inLaps(int laps) {
    List<Point> all = new ArrayList<>();
    for (int i = 0; i < laps; i++) {
      all.addAll(waypoints);
    }
    return with(all, List.of(), List.of(), ground);
  }

  /** The same field on different ground. */
  SuasField on(Terrain hills) {
    List<SuasTarget> raised = new ArrayList<>();
    targets.forEach(each -> raised.add(each.up(hills.heightM(each.eastM(), each.northM()))));
    return with(waypoints, searchArea, raised, hills);
  }

  private SuasField with(
      List<Point> places, List<Point> area, List<SuasTarget> things, Terrain below) {
    return new SuasField(
        runwayRad,
        boundary,
        floorM,
        ceilingM,
        List.copyOf(places),
        pillars,
        area,
        resolutionM,
        List.copyOf(things),
        traffic,
        windMps,
        windFromRad,
        drop,
        qnhPa,
        seed,
        below);
  }

  /** Converts between the field and the earth. */
  static LocalPlane plane() {
    return new LocalPlane(ORIGIN);
  }

  /** Where the aircraft starts. */
  Point start() {
    return Point.of(
        -RUNWAY_HALF_M * Math.sin(runwayRad), -RUNWAY_HALF_M * Math.cos(runwayRad), 0.0);
  }

  /** Boundary, search area and pillars, for the map. */
  List<Surroundings.Area> areas() {
    List<Surroundings.Area> areas = new ArrayList<>();
    areas.add(new Surroundings.Area(outline("boundary", boundary), false));
    if (!searchArea.isEmpty()) {
      areas.add(new Surroundings.Area(outline("search area", searchArea), false));
    }
    for (int i = 0; i < pillars.size(); i++) {
      Pillar pillar = pillars.get(i);
      List<Point> round = new ArrayList<>();
      for (int k = 0; k < CORNERS; k++) {
        double angle = 2.0 * Math.PI * k / CORNERS;
        round.add(
            Point.of(
                pillar.eastM() + pillar.radiusM() * Math.cos(angle),
                pillar.northM() + pillar.radiusM() * Math.sin(angle),
                0.0));
      }
      areas.add(new Surroundings.Area(outline("pillar " + (i + 1), round), true));
    }
    return areas;
  }

  private static Polygon outline(String name, List<Point> corners) {
    List<Point> places = new ArrayList<>();
    corners.forEach(each -> places.add(plane().at(each.x(), each.y(), 0.0).point()));
    Geodetic first = Geodetic.of(places.get(0));
    return new Polygon()
        .points(places)
        .uid(name)
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(first.longitudeDeg())
        .y(first.latitudeDeg());
  }

  /** The other aircraft. */
  List<ScriptedMover> movers() {
    return movers(true);
  }

  private List<ScriptedMover> movers(boolean transponders) {
    List<ScriptedMover> movers = new ArrayList<>();
    for (Traffic each : traffic) {
      Sphere body =
          new Sphere()
              .radius(BODY_M)
              .uid(each.name())
              .objectType("aircraft")
              .referenceFrame(ReferenceFrame.LOCAL_ENU)
              .x(each.from().x())
              .y(each.from().y())
              .z(each.from().z());
      movers.add(
          new ScriptedMover(
              body,
              plane(),
              List.of(new ScriptedMover.Waypoint(each.to(), each.speedMps(), 0.0)),
              ScriptedMover.End.RETURN,
              0.0,
              false,
              transponders));
    }
    return movers;
  }

  /**
   * The world of the run. The pillars are virtual: flying through one only costs points.
   *
   * @param transponders whether other aircraft have them
   */
  World world(boolean transponders) {
    return World.at(ORIGIN)
        .with(ground)
        .withMovers(movers(transponders))
        .with(Wind.gusty(windFromRad, windMps, seed));
  }

  /** Whether a position lies in a polygon of the field. */
  static boolean isInside(List<Point> polygon, double eastM, double northM) {
    boolean inside = false;
    for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      Point a = polygon.get(i);
      Point b = polygon.get(j);
      if (a.y() > northM != b.y() > northM
          && eastM < a.x() + (b.x() - a.x()) * (northM - a.y()) / (b.y() - a.y())) {
        inside = !inside;
      }
    }
    return inside;
  }

  /** Distance of a position from the edges of a polygon [m]. */
  static double edgeM(List<Point> polygon, double eastM, double northM) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < polygon.size(); i++) {
      Point a = polygon.get(i);
      Point b = polygon.get((i + 1) % polygon.size());
      least = Math.min(least, Point.of(eastM, northM, 0.0).flatDistanceTo(a, b));
    }
    return least;
  }
}
