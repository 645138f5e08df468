package org.u2sa.scenarios.fields;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.planning.PathPlanner;
import org.u2sa.testkit.ServiceKit;

/**
 * A small aeroplane of 18 m/s in a field of cylinders, walls and traffic that it learns of 500 m
 * ahead. It banks as far as 40° with a lag, as a guidance law on its navigation points says (Park,
 * Deyst, How: AIAA 2004-4900, eq. 2); the planner counts on 33°.
 */
final class AircraftRun implements AutoCloseable {
  static final RandomField.Kind KIND =
      new RandomField.Kind(2000.0, 15.0, 90.0, 0.25, 120.0, 3, 30.0, 14.0, 2, false);

  /** Radius of the turns that the planner counts on [m]. */
  static final double TURN_M = 18.0 * 18.0 / 6.4;

  /** Half the span, CLEARANCE, and a cell of the map [m]. */
  static final double NEEDED_M = 1.5 + 10.0 + 5.0;

  private static final double RANGE_M = 500.0;
  private static final double HALF_SPAN_M = 1.5;
  private static final double STEP_S = 0.1;
  private static final double LIMIT_S = 900.0;
  private static final double SPEED_MPS = 18.0;
  private static final double BANK_RAD = Math.toRadians(40.0);
  private static final double ROLL_S = 0.5;
  private static final double ALTITUDE_M = 100.0;
  private static final Map<String, Object> PLANNER =
      Map.ofEntries(
          Map.entry("LOOK AHEAD", 30.0),
          Map.entry("LOOK AHEAD TIME", 2.0),
          Map.entry("TURN ACCELERATION", 6.4),
          Map.entry("TURN LAG", 0.5),
          Map.entry("VEHICLE FRONT", 1.0),
          Map.entry("VEHICLE REAR", 1.0),
          Map.entry("VEHICLE WIDTH", 3.0),
          Map.entry("CLEARANCE", 10.0),
          Map.entry("INFLATION", 40.0),
          Map.entry("PLANNING CELL", 5.0),
          Map.entry("PLANNING SPAN", 2500.0),
          Map.entry("PLANNED SPEED", SPEED_MPS),
          Map.entry("MIN SPEED", SPEED_MPS),
          Map.entry("TRAFFIC CLEARANCE", 15.0),
          Map.entry("TRAFFIC HORIZON", 14.0),
          Map.entry("REPLAN INTERVAL", 1.0),
          Map.entry("STUCK AFTER", 60.0),
          Map.entry("VERTICAL CLEARANCE", 20.0),
          Map.entry("GIVE UP AFTER", 30.0));

  final ServiceKit kit = new ServiceKit();
  private final RandomField field;
  private final boolean remembers;
  private final Set<String> known = new HashSet<>();
  private final List<String> contacts = new ArrayList<>();
  private double east;
  private double north;
  private double heading;
  private double bank;

  AircraftRun(RandomField field, String planner) {
    this(field, planner, true);
  }

  /**
   * @param remembers whether what stands is still known when it is out of sight, as the World
   *     Modeler's map of objects has it
   */
  AircraftRun(RandomField field, String planner, boolean remembers) {
    this.field = field;
    this.remembers = remembers;
    east = field.startEast;
    north = field.startNorth;
    heading = field.startHeading;
    PLANNER.forEach(kit::with);
    kit.with("PLANNER", planner).start(PathPlanner::new);
  }

  FieldResult run() {
    List<double[]> track = new ArrayList<>();
    boolean reported = false;
    String reason = "";
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goal())).upcoming(List.<Waypoint>of()));
    int step = 0;
    while (kit.nowS() < LIMIT_S && !reported) {
      if (step++ % 5 == 0) {
        kit.publish(Channels.OBJECTS, seen());
      }
      track.add(new double[] {east, north});
      kit.publish(Channels.STATE, state());
      fly(kit.latest(Channels.NAVIGATION));
      Optional<GoalInformation> report = kit.latest(Channels.GOAL_REPORTS);
      if (report.isPresent()) {
        reported = true;
        reason = report.get().completed() ? "" : report.get().reason().orElse("no reason");
      }
      kit.forget();
      kit.advance(STEP_S);
      touch();
    }
    boolean there = Math.hypot(east - field.goalEast, north - field.goalNorth) < 45.0;
    return new FieldResult(
        reported && reason.isEmpty() && there, reason, contacts, List.of(), kit.nowS(), track);
  }

  private void fly(Optional<NavigationPoint> point) {
    double wanted = 0.0;
    if (point.isPresent()) {
      Point body = point.get().point();
      double right = -body.y() * Math.cos(bank) - body.z() * Math.sin(bank); // undo the roll
      double away = Math.hypot(body.x(), right);
      double off = Math.atan2(right, body.x());
      double limited = Math.max(-Math.PI / 2.0, Math.min(Math.PI / 2.0, off));
      // a = 2 V² / L · sin η
      wanted =
          Math.atan(2.0 * SPEED_MPS * SPEED_MPS / away * Math.sin(limited) / Gravity.STANDARD_MPS2);
      wanted = Math.max(-BANK_RAD, Math.min(BANK_RAD, wanted));
    }
    bank += (wanted - bank) * STEP_S / ROLL_S;
    heading += Gravity.STANDARD_MPS2 * Math.tan(bank) / SPEED_MPS * STEP_S;
    north += SPEED_MPS * Math.cos(heading) * STEP_S;
    east += SPEED_MPS * Math.sin(heading) * STEP_S;
  }

  private Waypoint goal() {
    return new Waypoint()
        .uid("1")
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(field.goalEast)
        .y(field.goalNorth)
        .z(ALTITUDE_M)
        .horizontalThreshold(40.0);
  }

  private StateInformation state() {
    return new StateInformation()
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east)
        .z(-ALTITUDE_M)
        .phi(bank)
        .theta(0.0)
        .psi(heading)
        .xDot(SPEED_MPS * Math.cos(heading))
        .yDot(SPEED_MPS * Math.sin(heading));
  }

  private ObjectList seen() {
    List<ObjectDescription> seen = new ArrayList<>();
    for (ObjectDescription obstacle : field.obstacles) {
      boolean near = obstacle.distanceTo(Point.of(east, north, 0.0)) < RANGE_M;
      if (near || (remembers && known.contains(obstacle.uid()))) {
        known.add(obstacle.uid());
        ObjectDescription high = obstacle.copy();
        high.z(ALTITUDE_M);
        seen.add(high);
      }
    }
    double now = kit.nowS();
    for (int i = 0; i < field.traffic.size(); i++) {
      RandomField.Traffic other = field.traffic.get(i);
      MovingSphere sphere = new MovingSphere().radius(other.radiusM);
      sphere
          .uid("T" + i)
          .referenceFrame(ReferenceFrame.LOCAL_ENU)
          .x(other.eastM(now))
          .y(other.northM(now))
          .z(ALTITUDE_M);
      sphere.timestamp(kit.clock().micros());
      sphere.motion().velocity(Point.of(other.eastMps(now), other.northMps(now), 0.0));
      seen.add(sphere);
    }
    return new ObjectList().objects(seen);
  }

  private void touch() {
    for (ObjectDescription obstacle : field.obstacles) {
      boolean near = obstacle.distanceTo(Point.of(east, north, 0.0)) < HALF_SPAN_M;
      if (near && !contacts.contains(obstacle.uid())) {
        contacts.add(obstacle.uid());
      }
    }
    for (int i = 0; i < field.traffic.size(); i++) {
      RandomField.Traffic other = field.traffic.get(i);
      double away = Math.hypot(other.eastM(kit.nowS()) - east, other.northM(kit.nowS()) - north);
      if (away < other.radiusM && !contacts.contains("T" + i)) {
        contacts.add("T" + i);
      }
    }
  }

  @Override
  public void close() {
    kit.close();
  }
}
