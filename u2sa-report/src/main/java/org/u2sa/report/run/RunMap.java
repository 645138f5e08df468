package org.u2sa.report.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.report.message.FieldPath;
import org.u2sa.report.page.Trace;

/**
 * Content of the map, in metres east and north of the first state or of another run's: estimated
 * and true track, goals, obstacles.
 */
final class RunMap {
  private static final int SIDES = 4;
  private static final FieldPath RADIUS = FieldPath.parse("radius");
  private static final FieldPath LENGTH = FieldPath.parse("length");
  private static final FieldPath WIDTH = FieldPath.parse("width");
  private static final FieldPath PSI = FieldPath.parse("psi");
  private static final FieldPath POINTS = FieldPath.parse("points");
  private static final double POINT_M = 0.3;
  private static final double GRID_EAST_M = 1e6; // upper bound of UTM eastings
  private static final double GRID_NORTH_M = 1e7;
  private static final double SAME_PLACE_M = 20_000.0; // farther runs do not fit on one map

  private final Trace east = new Trace("east");
  private final Trace north = new Trace("north");
  private final Map<String, JsonText> goals = new LinkedHashMap<>();
  private final Map<String, Point> goalPlaces = new LinkedHashMap<>();
  private final ObstacleCells cells = new ObstacleCells();
  private final Map<String, JsonText> objects = new LinkedHashMap<>();
  private boolean isShortened;
  private Point at; // latest map position; null before the first state
  private Point fromLocal; // from a local frame to the map; null if unknown
  private final Optional<Geodetic> shared; // origin of another run
  private Geodetic origin; // null before the first state

  /**
   * @param shared origin of another run's map, which is used if this run is not far from it
   */
  RunMap(Optional<Geodetic> shared) {
    this.shared = shared;
  }

  /** Origin of the map; empty before the first state. */
  Optional<Geodetic> origin() {
    return Optional.ofNullable(origin);
  }

  /** Map position; empty before the map has an origin. */
  Optional<Point> place(Geodetic at) {
    return Optional.ofNullable(origin).map(from -> from.enuOf(at));
  }

  /** Adds an estimate; returns its map position, if any. */
  Optional<Point> take(double timeS, StateInformation state) {
    if (!state.referenceFrame().isEarth() || state.x().isEmpty() || state.y().isEmpty()) {
      return Optional.empty();
    }
    Point own = Point.of(state.x().getAsDouble(), state.y().getAsDouble(), state.z().orElse(0.0));
    Geodetic at = Geodetic.of(UtmGrid.global(state.referenceFrame(), own));
    if (origin == null) {
      origin = shared.filter(other -> other.distanceM(at) < SAME_PLACE_M).orElse(at);
    }
    Point point = origin.enuOf(at);
    this.at = point;
    east.add(timeS, point.x());
    north.add(timeS, point.y());
    return Optional.of(point);
  }

  /** Updates the current goals; the absence of a goal does not reveal its result. */
  void take(GoalList list) {
    list.goals().forEach(this::take);
  }

  /** Updates a goal from a list or a report of its end. */
  void take(GoalInformation goal) {
    if (goal instanceof Waypoint waypoint && waypoint.x().isPresent()) {
      place(waypoint.referenceFrame(), waypoint.x().getAsDouble(), waypoint.y().orElse(0.0))
          .ifPresent(at -> take(waypoint, at));
    }
  }

  private void take(Waypoint waypoint, Point at) {
    String name = ReportLimits.clipped(waypoint.uid());
    if (goals.size() >= ReportLimits.MAX_GOALS && !goals.containsKey(name)) {
      isShortened = true;
      return;
    }
    goalPlaces.put(name, at);
    goals.put(
        name,
        new JsonText()
            .put("name", name)
            .put("x", Trace.rounded(at.x()))
            .put("y", Trace.rounded(at.y()))
            .put("r", waypoint.horizontalThreshold())
            .put("done", waypoint.completed() && !waypoint.abandoned()));
  }

  boolean isShortened() {
    return isShortened;
  }

  /** Map position of a goal; empty if unknown. */
  Optional<Point> goal(String uid) {
    return Optional.ofNullable(goalPlaces.get(ReportLimits.clipped(uid)));
  }

  /** Adds dead reckoning in a local frame, which places objects in that frame on the map. */
  void takeLocal(StateInformation state) {
    if (at != null && state.x().isPresent() && state.y().isPresent()) {
      Point there = Point.of(state.x().getAsDouble(), state.y().getAsDouble(), 0.0);
      fromLocal = east(state.referenceFrame(), there).map(at::minus).orElse(fromLocal);
    }
  }

  /** Converts a point of a local frame to east and north. */
  private static Optional<Point> east(ReferenceFrame frame, Point point) {
    if (frame.equals(ReferenceFrame.LOCAL_ENU)) {
      return Optional.of(point);
    }
    return frame.equals(ReferenceFrame.LOCAL_NED)
        ? Optional.of(Point.of(point.y(), point.x(), -point.z()))
        : Optional.empty();
  }

  private Optional<Point> place(ReferenceFrame frame, double x, double y) {
    double altitudeM = origin == null ? 0.0 : origin.altitudeM();
    if (frame.equals(ReferenceFrame.GLOBAL)) {
      return Math.abs(y) <= 90.0 ? place(new Geodetic(x, y, altitudeM)) : Optional.empty();
    }
    if (frame.isUtm()) {
      boolean isOnGrid = x >= 0.0 && x <= GRID_EAST_M && y >= 0.0 && y <= GRID_NORTH_M;
      return isOnGrid
          ? place(new UtmGrid(frame).place(Point.of(x, y, altitudeM)))
          : Optional.empty();
    }
    return fromLocal == null
        ? Optional.empty()
        : east(frame, Point.of(x, y, 0.0)).map(fromLocal::plus);
  }

  void take(OccupancyGrid grid) {
    cells.take(grid, point -> place(grid.referenceFrame(), point.x(), point.y()));
  }

  /**
   * Updates objects with their latest observation; objects in the vehicle's own frame are not
   * drawn.
   */
  void take(ObjectList list) {
    for (ObjectDescription object : list.objects()) {
      place(object.referenceFrame(), object.x(), object.y())
          .ifPresent(place -> keep(object, place));
    }
  }

  private void keep(ObjectDescription object, Point place) {
    String name = ReportLimits.clipped(object.uid());
    if (objects.size() < ReportLimits.MAX_OBJECTS || objects.containsKey(name)) {
      objects.put(name, shape(name, object, place));
    } else {
      isShortened = true;
    }
  }

  private JsonText shape(String name, ObjectDescription object, Point at) {
    JsonText shape = new JsonText().put("name", name);
    OptionalDouble radius = RADIUS.number(object);
    if (radius.isPresent()) {
      return circle(shape, at, radius.getAsDouble());
    }
    if (POINTS.value(object).orElse(null) instanceof List<?> corners && corners.size() > 1) {
      List<Double> outline = new ArrayList<>();
      int each = 1 + corners.size() / ReportLimits.MAX_CORNERS;
      for (int i = 0; i < corners.size(); i += each) {
        if (corners.get(i) instanceof Point point) {
          place(object.referenceFrame(), point.x(), point.y()).ifPresent(p -> add(outline, p));
        }
      }
      return shape.put("outline", outline);
    }
    if (LENGTH.number(object).isPresent() && WIDTH.number(object).isPresent()) {
      return shape.put("outline", box(object, at));
    }
    return circle(shape, at, POINT_M);
  }

  private static JsonText circle(JsonText shape, Point at, double radius) {
    return shape.put("x", Trace.rounded(at.x())).put("y", Trace.rounded(at.y())).put("r", radius);
  }

  /**
   * Corners of a box whose length axis points to psi: clockwise from north, but anticlockwise from
   * east in LOCAL_ENU.
   */
  private static List<Double> box(ObjectDescription object, Point at) {
    boolean isEastFirst = object.referenceFrame().equals(ReferenceFrame.LOCAL_ENU);
    double turned = PSI.number(object).orElse(0.0);
    double psi = isEastFirst ? Math.PI / 2.0 - turned : turned;
    double along = LENGTH.number(object).getAsDouble() / 2;
    double across = WIDTH.number(object).getAsDouble() / 2;
    List<Double> outline = new ArrayList<>();
    for (int i = 0; i < SIDES; i++) {
      double a = i == 0 || i == 1 ? along : -along;
      double b = i == 0 || i == SIDES - 1 ? across : -across;
      add(
          outline,
          Point.of(
              at.x() + a * Math.sin(psi) + b * Math.cos(psi),
              at.y() + a * Math.cos(psi) - b * Math.sin(psi),
              0.0));
    }
    return outline;
  }

  private static void add(List<Double> outline, Point point) {
    outline.add(Trace.rounded(point.x()));
    outline.add(Trace.rounded(point.y()));
  }

  /** The complete map; truth is null if unknown. */
  JsonText json(TruthTrack truth, double truthFromS) {
    JsonText json =
        new JsonText()
            .put("isShared", origin != null && shared.filter(origin::equals).isPresent())
            .put("track", line(east, north))
            .put("goals", new ArrayList<>(goals.values()))
            .put("objects", new ArrayList<>(objects.values()))
            .put("cells", cells.json());
    if (truth != null && origin != null) {
      Trace x = new Trace("east");
      Trace y = new Trace("north");
      for (double[] row : truth.rows()) {
        Point at = origin.enuOf(new Geodetic(row[1], row[2], row[3]));
        x.add(row[0] + truthFromS, at.x());
        y.add(row[0] + truthFromS, at.y());
      }
      json.put("truth", line(x, y));
    }
    return json;
  }

  /** Time, east and north of every nth point, interleaved. */
  private static List<Double> line(Trace x, Trace y) {
    int step = Math.max(1, x.size() / 2_500);
    List<Double> line = new ArrayList<>();
    for (int i = 0; i < x.size(); i += step) {
      line.add(Math.round(x.time(i) * 100) / 100.0);
      line.add(Math.round(x.value(i) * 1e3) / 1e3);
      line.add(Math.round(y.value(i) * 1e3) / 1e3);
    }
    return line;
  }
}
