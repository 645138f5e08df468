package org.u2sa.sim.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.sim.motion.Arguments;

/**
 * An object that moves along waypoints in simulated time: a vessel, walker, vehicle or aircraft. It
 * starts at its own position, travels in straight lines at constant speeds, and does not react to
 * anything. Boxes and rectangles point along their course. Immutable.
 */
public final class ScriptedMover {
  private static final int MAX_WAYPOINTS = 10_000;
  private static final double MAX_SPEED_MPS = 1_000.0;
  private static final double FARTHEST_M = 1e8;
  private static final double MAX_WAIT_S = 1e6;

  private final ObjectDescription object;
  private final double radiusM;
  private final double delayS;
  private final boolean floats;
  private final boolean hasTransponder;
  private final boolean repeats;
  private final List<Leg> legs;
  private final double[] ends; // end of each leg's wait, relative to the end of the delay [s]

  /** Behaviour after the last waypoint. */
  public enum End {
    /** Stops there. */
    STOP,
    /** Travels straight to the start and repeats. */
    LOOP,
    /** Travels back along the waypoints and repeats. */
    RETURN
  }

  /**
   * A waypoint.
   *
   * @param place in the object's frame
   * @param speedMps speed on the way there [m/s]
   * @param waitS duration of the stop there [s]
   */
  public record Waypoint(Point place, double speedMps, double waitS) {
    /**
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Waypoint {
      Arguments.requirePositive("speed [m/s]", speedMps);
      Arguments.requireInside("speed [m/s]", speedMps, 0.0, MAX_SPEED_MPS);
      Arguments.requireInside("wait [s]", waitS, 0.0, MAX_WAIT_S);
    }
  }

  /**
   * State at one time.
   *
   * @param position position of the centre: east, north, up [m]
   * @param velocity east, north, up [m/s]
   * @param courseRad direction of travel, anticlockwise from east [rad]
   */
  public record State(Point position, Point velocity, double courseRad) {}

  private record Leg(Point from, Point to, double speedMps, double waitS, double courseRad) {
    double travelS() {
      return from.distanceTo(to) / speedMps;
    }
  }

  /**
   * Creates a mover.
   *
   * @param object a box, rectangle, cylinder, circle or sphere in a frame of the world, at its
   *     start
   * @param delayS time before it starts [s]
   * @param floats whether waves lift it
   * @param hasTransponder whether traffic receivers detect it
   * @throws IllegalArgumentException if the shape or frame is not supported, or there are no
   *     waypoints or too many
   */
  public ScriptedMover(
      ObjectDescription object,
      LocalPlane plane,
      List<Waypoint> way,
      End end,
      double delayS,
      boolean floats,
      boolean hasTransponder) {
    if (object.referenceFrame().isBody()) {
      throw new IllegalArgumentException(
          object.referenceFrame() + ": expected a frame of the world");
    }
    if (way.isEmpty() || way.size() > MAX_WAYPOINTS) {
      throw new IllegalArgumentException(way.size() + " waypoints; expected 1…" + MAX_WAYPOINTS);
    }
    this.delayS = Arguments.requireInside("delay [s]", delayS, 0.0, MAX_WAIT_S);
    this.floats = floats;
    this.hasTransponder = hasTransponder;
    repeats = end != End.STOP;
    radiusM = radiusM(object);
    legs = legs(object, plane, way, end);
    ends = new double[legs.size()];
    double time = 0.0;
    for (int i = 0; i < ends.length; i++) {
      time += legs.get(i).travelS() + legs.get(i).waitS;
      ends[i] = time;
    }
    this.object = object.copy();
    this.object.referenceFrame(ReferenceFrame.LOCAL_ENU);
    place(this.object, at(0.0));
    this.object.freeze();
  }

  private static List<Leg> legs(
      ObjectDescription object, LocalPlane plane, List<Waypoint> way, End end) {
    List<Point> places =
        new ArrayList<>(List.of(Zone.inWorld(object.referenceFrame(), plane, object.center())));
    List<Waypoint> all = new ArrayList<>(way);
    way.forEach(each -> places.add(Zone.inWorld(object.referenceFrame(), plane, each.place)));
    if (end == End.LOOP) {
      places.add(places.get(0));
      all.add(new Waypoint(Point.ORIGIN, way.get(way.size() - 1).speedMps, 0.0));
    } else if (end == End.RETURN) {
      List<Point> back = new ArrayList<>(places.subList(0, places.size() - 1));
      List<Waypoint> backWay = new ArrayList<>(way);
      Collections.reverse(back);
      Collections.reverse(backWay);
      places.addAll(back);
      for (int i = 0; i < backWay.size(); i++) {
        double wait = i + 1 < backWay.size() ? backWay.get(i + 1).waitS : 0.0;
        all.add(new Waypoint(Point.ORIGIN, backWay.get(i).speedMps, wait));
      }
    }
    for (Point each : places) {
      Arguments.requireInside("place on the plane [m]", each.distance(), 0.0, FARTHEST_M);
    }
    List<Leg> legs = new ArrayList<>();
    double course = 0.0;
    for (int i = 0; i < all.size(); i++) {
      Point from = places.get(i);
      Point to = places.get(i + 1);
      if (Math.hypot(to.x() - from.x(), to.y() - from.y()) > 0.0) {
        course = StrictMath.atan2(to.y() - from.y(), to.x() - from.x());
      }
      legs.add(new Leg(from, to, all.get(i).speedMps, all.get(i).waitS, course));
    }
    return List.copyOf(legs);
  }

  private static double radiusM(ObjectDescription object) {
    if (object instanceof Box box) {
      return 0.5 * Math.hypot(box.length(), box.width());
    } else if (object instanceof Rectangle flat) {
      return 0.5 * Math.hypot(flat.length(), flat.width());
    } else if (object instanceof Cylinder cylinder) {
      return cylinder.radius();
    } else if (object instanceof Circle disc) {
      return disc.radius();
    } else if (object instanceof Sphere ball) {
      return ball.radius();
    }
    throw new IllegalArgumentException(
        object.type().name() + ": expected a Box, Rectangle, Cylinder, Circle or Sphere");
  }

  private static void place(ObjectDescription object, State state) {
    Point at = state.position;
    object.x(at.x()).y(at.y()).z(at.z());
    object.motion().velocity(state.velocity);
    if (object instanceof Box box) {
      box.psi(state.courseRad);
    } else if (object instanceof Rectangle flat) {
      flat.psi(state.courseRad);
    }
  }

  /** State at a time since the start of the run [s], in still water. */
  public State at(double timeS) {
    double time = timeS - delayS;
    double total = ends[ends.length - 1];
    if (time < 0.0) {
      Leg first = legs.get(0);
      return new State(first.from, Point.ORIGIN, first.courseRad);
    }
    if (!repeats && time >= total) {
      Leg last = legs.get(legs.size() - 1);
      return new State(last.to, Point.ORIGIN, last.courseRad);
    }
    double since = repeats && total > 0.0 ? time % total : Math.min(time, total);
    int index = 0;
    while (index < ends.length - 1 && since >= ends[index]) {
      index++;
    }
    Leg leg = legs.get(index);
    double along = since - (index == 0 ? 0.0 : ends[index - 1]);
    double travel = leg.travelS();
    if (along >= travel) {
      return new State(leg.to, Point.ORIGIN, leg.courseRad);
    }
    Point way = leg.to.minus(leg.from);
    return new State(
        leg.from.plus(way.times(along / travel)), way.times(1.0 / travel), leg.courseRad);
  }

  /** The object at a time of the run [s], in LOCAL_ENU; waves lift floating objects. */
  ObjectDescription objectAt(double timeS, Water water) {
    State state = at(timeS);
    ObjectDescription there = object.copy();
    place(there, state);
    if (floats && water != null) {
      Point at = state.position;
      there.z(at.z() + water.waveM(at.x(), at.y(), timeS));
    }
    there.freeze();
    return there;
  }

  public String uid() {
    return object.uid();
  }

  /** The object at its start, in LOCAL_ENU. */
  public ObjectDescription object() {
    return object;
  }

  /** Type of the object, such as a vessel. */
  public String objectType() {
    return object.objectType();
  }

  /** Horizontal radius of the object [m]. */
  public double radiusM() {
    return radiusM;
  }

  /** Whether its outline is the circle of its radius. */
  public boolean isRound() {
    return !(object instanceof Box) && !(object instanceof Rectangle);
  }

  /** Whether traffic receivers detect it. */
  public boolean hasTransponder() {
    return hasTransponder;
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%s, %d legs in %.1f s%s",
        uid(),
        legs.size(),
        ends[ends.length - 1],
        repeats ? ", repeated" : "");
  }
}
