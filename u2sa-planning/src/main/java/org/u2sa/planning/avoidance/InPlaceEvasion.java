package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.planning.avoidance.Avoidance.Wanted;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.VerticalRoom;
import org.u2sa.planning.seen.Mover;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Keeps a vehicle that can stop away from traffic while it climbs or descends in place, as in a
 * take-off or a landing. Confined to the planner's thread.
 */
final class InPlaceEvasion {
  private final SeenWorld world;
  private final VerticalEvasion climbing;
  private final SideStep sideStep;
  private final Supplier<AvoidanceVariables> settings;
  private final Supplier<LineSettings> lines;
  private final Arcs arcs;

  /** Creates the chooser of motions among traffic. */
  interface Arcs {
    ArcChooser among(
        Situation now, Vehicle vehicle, List<Mover> traffic, Optional<VerticalRoom> room);
  }

  InPlaceEvasion(
      SeenWorld world,
      VerticalEvasion climbing,
      Supplier<AvoidanceVariables> settings,
      Supplier<LineSettings> lines,
      BiConsumer<String, Boolean> say,
      Arcs arcs) {
    this.world = world;
    this.climbing = climbing;
    this.settings = settings;
    this.lines = lines;
    this.arcs = arcs;
    sideStep = new SideStep(world, say);
  }

  /** Receives the fence in force, whose areas it respects. */
  void see(FenceState fence) {
    sideStep.see(fence);
  }

  /**
   * Way that keeps away from traffic, as of the last update of the world: north, east, down [m].
   * Vertically, it is the wanted one, none, or up or down. Over known ground, a descent to land
   * leads away from what is above, and the vehicle does not climb towards that either.
   *
   * @param goal UID of the goal
   * @param way to the next point: north, east, down [m]
   */
  Point way(String goal, Vehicle vehicle, StateInformation state, Point way, KnownGround ground) {
    AvoidanceVariables now = settings.get();
    PlanningPlane plane = world.plane(state);
    Point at = vehicle.on(plane);
    Place to = vehicle.place().at(vehicle.place().upM().orElseThrow() - way.z());
    Optional<Point> spot = ground.spot(vehicle, at);
    Optional<VerticalRoom> room = climbing.room(state, at, way, to, now, world, plane, spot);
    List<Mover> traffic = room.isPresent() ? world.allMovers() : world.movers();
    double downM = traffic.isEmpty() ? way.z() : downM(vehicle, at, way, ground, room, traffic);
    boolean lands = downM > 0.0 && downM == way.z(); // the goal lies below the fence's floor
    Point apart =
        Point.of(
            way.x(),
            way.y(),
            lands ? downM : climbing.inside(plane, at.z(), vehicle.downMps(), downM));
    return ground.lands() || room.isEmpty() || way.z() > 0.0
        ? apart
        : sideStep.way(goal, vehicle, state, apart, spot, traffic, now);
  }

  private double downM(
      Vehicle vehicle,
      Point at,
      Point way,
      KnownGround ground,
      Optional<VerticalRoom> room,
      List<Mover> traffic) {
    AvoidanceVariables now = settings.get();
    Place to = vehicle.place().at(vehicle.place().upM().orElseThrow() - way.z());
    Optional<Point> spot = ground.spot(vehicle, at);
    Wanted wanted = new Wanted("", to, 0.0, OptionalDouble.empty(), OptionalDouble.empty());
    Pose pose = new Pose(at.x(), at.y(), vehicle.headingRad());
    double cellM = world.costs().frame().cellM();
    Situation situation = Situation.of(pose, way, wanted, vehicle, cellM, now, lines.get());
    double keptM = situation.body().circleM() + now.trafficClearance();
    long micros = vehicle.timestampMicros();
    if (way.z() > 0.0 && VerticalGuard.isOver(traffic, at, keptM, micros)) {
      return 0.0;
    }
    List<Mover> above =
        spot.isPresent() ? VerticalGuard.above(traffic, at, micros) : List.<Mover>of();
    List<Mover> minded = new ArrayList<>(traffic);
    if (ground.lands() && way.z() > 0.0) {
      minded.removeAll(above);
    }
    boolean isFree = arcs.among(situation, vehicle, minded, room).inPlaceM(way.z()) == way.z();
    if (isFree || ground.touchesDown()) {
      return way.z();
    }
    boolean isBelow =
        spot.filter(low -> KnownGround.isLow(low, at)).isPresent()
            || arcs.among(situation, vehicle, above, room).inPlaceM(way.z()) != way.z();
    Optional<VerticalRoom> allowed = isBelow ? room.map(VerticalRoom::withoutClimb) : room;
    return arcs.among(situation, vehicle, traffic, allowed).inPlaceM(way.z());
  }
}
