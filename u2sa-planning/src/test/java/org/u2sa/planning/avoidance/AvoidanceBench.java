package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.MotionLimits;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.route.RouteRequest;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.seen.SeenWorld;
import org.u2sa.service.motion.Drift;

/** A rover on a plane with a planner that answers as told. Its goal is 8 m north of the origin. */
final class AvoidanceBench {
  static final double RADIUS_M = 0.6;
  private static final double GOAL_M = 8.0;
  private static final double CELL_M = 0.1;
  private static final double SPAN_M = 20.0;

  private double heightM;
  final AvoidanceVariables settings;
  final List<RouteRequest> requests = new ArrayList<>();
  final List<String> said = new ArrayList<>();
  final SeenWorld world =
      new SeenWorld(
          () ->
              new SeenWorld.Reading(
                  CELL_M,
                  SPAN_M,
                  new Inflation(RADIUS_M, 1.4, 3.0),
                  0.65,
                  "corridor",
                  List.of(),
                  0.0,
                  0.0));
  final Passages passages =
      new Passages(this::settings, () -> this.turnsOnTheSpot, () -> this.checksShape);
  final RouteKeeper routes =
      new RouteKeeper(world, new VirtualObstacles(world), passages, () -> this::plan, this::say);
  boolean turnsOnTheSpot; // narrower passages exist only for vehicles that do,
  boolean checksShape; // or for planners that do
  Route answer = northward(GOAL_M, GOAL_M);
  final StateInformation state =
      new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).z(0.0).psi(0.0);

  AvoidanceBench() {
    this(Map.of("OVERLOOK AFTER", 10.0, "RECOVERIES", 2));
  }

  AvoidanceBench(Map<String, Object> variables) {
    settings =
        XmlConfiguration.inMemory("PathPlanner", variables)
            .settings(AvoidanceVariables.class)
            .get();
    world.plane(state);
    see();
  }

  private AvoidanceVariables settings() {
    return settings;
  }

  private Route plan(RouteRequest request) {
    requests.add(request);
    return answer;
  }

  void say(String what, boolean isWarning) {
    said.add(what);
  }

  void see(ObjectDescription... objects) {
    world.see(new ObjectList().objects(List.of(objects)), 0L);
    world.update(state, 0.0, 0.0, 0.0, 0.0);
  }

  /** A grid around the vehicle in which nothing was seen south of a northing. */
  void seeNorthOf(double northM) {
    int count = (int) Math.round(SPAN_M / CELL_M);
    byte[] cells = new byte[count * count];
    Arrays.fill(cells, (byte) -100);
    // x is north: a column of the grid has the same northing
    for (int i = 0; i < cells.length; i++) {
      if ((i % count) * CELL_M - 0.5 * SPAN_M < northM) {
        cells[i] = OccupancyGrid.UNKNOWN;
      }
    }
    world.see(
        new OccupancyGrid()
            .anchor(ReferenceFrame.LOCAL_NED, Point.ORIGIN)
            .corner(-0.5 * SPAN_M, -0.5 * SPAN_M)
            .resolution(CELL_M)
            .cells(count, cells),
        0L);
  }

  static ObjectDescription post(double northM, double eastM) {
    return new Sphere()
        .uid("post " + northM + " " + eastM)
        .objectType("post")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(northM)
        .y(eastM)
        .radius(0.1);
  }

  /** Height difference to the goal in situations from now on. */
  void height(double metres) {
    heightM = metres;
  }

  static ObjectDescription ball(double northM, double radiusM) {
    return ((Sphere) post(northM, 0.0)).radius(radiusM);
  }

  static Route northward(double metres, double cost) {
    return Route.of(
        List.of(new Route.Point(0.0, 0.0, false), new Route.Point(metres, 0.0, false)), cost);
  }

  static long micros(double seconds) {
    return Clock.micros(seconds);
  }

  Situation at(double seconds) {
    return at(seconds, 0.0, 0.0);
  }

  Situation at(double seconds, double northM, double eastM) {
    return at(seconds, northM, eastM, 0.0);
  }

  Situation at(double seconds, double northM, double eastM, double headingRad) {
    return new Situation(
        new Pose(northM, eastM, headingRad),
        GOAL_M,
        0.0,
        heightM,
        OptionalDouble.empty(),
        0.5,
        new MotionLimits(1.0, 0.8, 1.0, 0.0, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.0),
        CELL_M,
        settings.body(true),
        0.0,
        settings,
        micros(seconds));
  }

  /** A vehicle with a turn radius of 1 m on the route, which is to arrive pointing north. */
  Situation steered(double seconds, double northM, double headingRad) {
    Situation turning = at(seconds, northM, 0.0, headingRad);
    return new Situation(
        turning.pose(),
        GOAL_M,
        0.0,
        heightM,
        OptionalDouble.of(0.0),
        0.5,
        turning.limits(),
        CELL_M,
        turning.body(),
        1.0,
        settings,
        turning.micros());
  }

  ArcChooser arcs(Situation now) {
    return new ArcChooser(
        world.costs(),
        now.body(),
        List.of(),
        now.limits(),
        now.pose(),
        0.0,
        now.micros(),
        Optional.empty(),
        Optional.empty(),
        Drift.NONE);
  }

  /** One step of an attempt. */
  ArcChoice step(GoalAttempt attempt, Situation now) {
    routes.update(now);
    return attempt.choose(arcs(now), now);
  }
}
