package org.u2sa.planning.air;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import org.u2sa.planning.curve.Curve;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

/**
 * Finds the shortest path around shapes for an aircraft with a turning circle: arcs around the
 * shapes, none of them tighter than the turning circle, and the tangents between them (a visibility
 * graph of circles: Chang, Choi, Kwon, Park, Yap: Shortest Path Amidst Disc Obstacles Is
 * Computable, SoCG 2005; the first and the last circle as in Dubins 1957). Obstacles smaller than
 * the turning circle are passed on a turning circle.
 *
 * <p>Searched by A*; tangents and arcs are created and checked lazily. Immutable.
 */
public final class TangentGraph {
  private static final double FULL = 2.0 * Math.PI;
  private static final double ROUNDING_RAD = 1.0e-7;
  private static final double TOUCHING = 1.0e-9; // tolerance of touching circles
  private static final int MAX_CIRCLES = 300;
  private static final int MAX_EXPANSIONS = 4000;
  private static final double ARC_SAMPLE_RAD = Math.toRadians(6.0);

  private static final byte FREE = 1;
  private static final byte BLOCKED = 2;

  /** A circle with a turn direction: 1 to the right, −1 to the left, 0 for a point. */
  private record Ring(double northM, double eastM, double radiusM, int sense) {}

  /** Arrival at a ring, with its predecessor. */
  private record Node(
      int ring, double headingRad, double cost, double estimate, Node from, int id) {}

  private final KeepOut keepOut;
  private final Pose start;
  private final double radiusM;
  private final double goalNorthM;
  private final double goalEastM;
  private final OptionalDouble goalHeadingRad;
  private final List<Ring> rings = new ArrayList<>();
  private final int firstGoal;
  private final double[] reached; // least cost by tangent, from ring to ring
  private final byte[] tangents; // whether they are free, likewise: 0 not checked yet

  private TangentGraph(
      KeepOut keepOut,
      Pose start,
      double goalNorthM,
      double goalEastM,
      OptionalDouble goalHeadingRad,
      double radiusM) {
    this.keepOut = keepOut;
    this.start = start;
    this.radiusM = radiusM;
    this.goalNorthM = goalNorthM;
    this.goalEastM = goalEastM;
    this.goalHeadingRad = goalHeadingRad;
    rings.add(beside(start, 1));
    rings.add(beside(start, -1));
    for (KeepOut.Round round : keepOut.rounds()) {
      double radius = Math.max(radiusM, 1.001 * round.avoidM());
      rings.add(new Ring(round.northM(), round.eastM(), radius, 1));
      rings.add(new Ring(round.northM(), round.eastM(), radius, -1));
    }
    List<Ring> goals = goals();
    for (Ring first : List.copyOf(rings.subList(0, 2))) {
      for (Ring last : goals) {
        if (last.sense() != -first.sense()) {
          addBetween(first, last);
        }
      }
    }
    firstGoal = rings.size();
    rings.addAll(goals);
    reached = new double[rings.size() * rings.size()];
    Arrays.fill(reached, Double.POSITIVE_INFINITY);
    tangents = new byte[reached.length];
  }

  private List<Ring> goals() {
    if (goalHeadingRad.isEmpty()) {
      return List.of(new Ring(goalNorthM, goalEastM, 0.0, 0));
    }
    Pose goal = new Pose(goalNorthM, goalEastM, goalHeadingRad.getAsDouble());
    return List.of(beside(goal, 1), beside(goal, -1));
  }

  /**
   * Adds circles flown in the opposite direction that touch the first and the last circle from
   * outside: the middle circles of paths with three turns (Dubins 1957), or with two to a point
   * without a heading.
   */
  private void addBetween(Ring first, Ring last) {
    double north = last.northM() - first.northM();
    double east = last.eastM() - first.eastM();
    double apart = Math.hypot(north, east);
    double toFirst = first.radiusM() + radiusM;
    double toLast = last.radiusM() + radiusM;
    // The three centres form a triangle; this is the foot and height of its apex on first–last:
    double along = (apart * apart + toFirst * toFirst - toLast * toLast) / (2.0 * apart);
    double square = toFirst * toFirst - along * along;
    if (!(square >= 0.0)) { // too far apart, or one inside the other
      return;
    }
    double aside = Math.sqrt(square);
    for (int side = -1; side <= 1; side += 2) {
      rings.add(
          new Ring(
              first.northM() + (along * north - side * aside * east) / apart,
              first.eastM() + (along * east + side * aside * north) / apart,
              radiusM,
              -first.sense()));
    }
  }

  /**
   * Finds the shortest path.
   *
   * @param clearanceM clearance to keep from shapes [m]
   * @param radiusM minimum turn radius [m], above 0
   * @return arcs and straights; empty if there is no path, or too many obstacles to search
   */
  public static Optional<Curve> shortest(
      List<PlanarShape> shapes,
      List<PlanarShape> corridors,
      double clearanceM,
      Pose start,
      double goalNorthM,
      double goalEastM,
      OptionalDouble goalHeadingRad,
      double radiusM) {
    KeepOut keepOut = new KeepOut(shapes, corridors, clearanceM, start);
    if (keepOut.rounds().size() > MAX_CIRCLES) {
      return Optional.empty();
    }
    return new TangentGraph(keepOut, start, goalNorthM, goalEastM, goalHeadingRad, radiusM)
        .search();
  }

  /** Turning circle of a pose in a direction. */
  private Ring beside(Pose pose, int sense) {
    return new Ring(
        pose.northM() - sense * radiusM * Math.sin(pose.headingRad()),
        pose.eastM() + sense * radiusM * Math.cos(pose.headingRad()),
        radiusM,
        sense);
  }

  private Optional<Curve> search() {
    PriorityQueue<Node> open =
        new PriorityQueue<>(Comparator.comparingDouble(Node::estimate).thenComparingInt(Node::id));
    int ids = 0;
    for (int ring = 0; ring < 2; ring++) {
      open.add(new Node(ring, start.headingRad(), 0.0, restM(ring), null, ids++));
    }
    for (int expanded = 0; !open.isEmpty() && expanded < MAX_EXPANSIONS; expanded++) {
      Node node = open.poll();
      if (node.ring() < 0) {
        return Optional.of(curve(node));
      }
      if (node.ring() >= firstGoal) {
        finish(node, ids++).ifPresent(open::add);
        continue;
      }
      for (int to = 2; to < rings.size(); to++) {
        Optional<Node> next = fly(node, to, ids);
        if (next.isPresent()) {
          reached[node.ring() * rings.size() + to] = next.get().cost();
          open.add(next.get());
          ids++;
        }
      }
    }
    return Optional.empty();
  }

  private double restM(int ring) {
    Ring at = rings.get(ring);
    return Math.max(
        0.0, Math.hypot(at.northM() - goalNorthM, at.eastM() - goalEastM) - at.radiusM());
  }

  /**
   * Expands a node around its ring and along the tangent to another; empty if blocked, or not
   * shorter than before.
   */
  private Optional<Node> fly(Node node, int to, int id) {
    Ring a = rings.get(node.ring());
    Ring b = rings.get(to);
    double north = b.northM() - a.northM();
    double east = b.eastM() - a.eastM();
    // centre to centre = length · ahead + k · right, k the difference of the signed radii
    double k = b.sense() * b.radiusM() - a.sense() * a.radiusM();
    double square = north * north + east * east - k * k;
    double touching = TOUCHING * (north * north + east * east);
    if (square < -touching || touching == 0.0) {
      return Optional.empty();
    }
    double length = square <= touching ? 0.0 : Math.sqrt(square);
    double heading = Math.atan2(east, north) - Math.atan2(k, length);
    double turned = turn(node.headingRad(), heading, a.sense());
    double cost = node.cost() + turned * a.radiusM() + length;
    int tangent = node.ring() * rings.size() + to;
    if (tangents[tangent] == BLOCKED || !(cost < reached[tangent])) {
      return Optional.empty();
    }
    double n1 = onRing(a, heading, true);
    double e1 = onRing(a, heading, false);
    double n2 = onRing(b, heading, true);
    double e2 = onRing(b, heading, false);
    if (tangents[tangent] == 0) {
      tangents[tangent] = keepOut.isFree(n1, e1, n2, e2) ? FREE : BLOCKED;
    }
    if (tangents[tangent] == BLOCKED || !arcIsFree(a, node.headingRad(), turned)) {
      return Optional.empty();
    }
    double rest = Math.hypot(n2 - goalNorthM, e2 - goalEastM);
    return Optional.of(new Node(to, heading, cost, cost + rest, node, id));
  }

  /** Expands a node with the last turn, to the heading at the goal. */
  private Optional<Node> finish(Node node, int id) {
    Ring ring = rings.get(node.ring());
    double heading = goalHeadingRad.orElse(node.headingRad());
    double turned = turn(node.headingRad(), heading, ring.sense());
    if (!arcIsFree(ring, node.headingRad(), turned)) {
      return Optional.empty();
    }
    double cost = node.cost() + turned * ring.radiusM();
    return Optional.of(new Node(-1, heading, cost, cost, node, id));
  }

  private static double turn(double from, double to, int sense) {
    double turned = (sense * (to - from)) % FULL;
    turned = turned < 0.0 ? turned + FULL : turned;
    return sense == 0 || turned > FULL - ROUNDING_RAD ? 0.0 : turned;
  }

  /** North or east coordinate of the point on a ring with a heading [m]. */
  private static double onRing(Ring ring, double heading, boolean north) {
    return north
        ? ring.northM() + ring.sense() * ring.radiusM() * Math.sin(heading)
        : ring.eastM() - ring.sense() * ring.radiusM() * Math.cos(heading);
  }

  /**
   * Whether an arc is free, checked at points on it: a chord would lie inside the ring and seem to
   * hit the ring's own shape.
   */
  private boolean arcIsFree(Ring ring, double from, double turned) {
    double metres = turned * ring.radiusM();
    int steps = (int) Math.ceil(Math.max(turned / ARC_SAMPLE_RAD, metres / keepOut.arcSampleM()));
    for (int i = 0; i <= steps && steps > 0; i++) {
      double heading = from + ring.sense() * turned * i / steps;
      double north = onRing(ring, heading, true);
      double east = onRing(ring, heading, false);
      if (!keepOut.isFree(north, east, north, east)) {
        return false;
      }
    }
    return true;
  }

  private Curve curve(Node end) {
    List<Curve.Piece> pieces = new ArrayList<>();
    Node to = end;
    while (to.from() != null) {
      Node from = to.from();
      Ring ring = rings.get(from.ring());
      double turned = turn(from.headingRad(), to.headingRad(), ring.sense());
      double arc = turned * ring.radiusM();
      double straight = to.cost() - from.cost() - arc;
      if (straight > 1.0e-6) {
        pieces.add(0, new Curve.Piece(straight, 0.0));
      }
      if (arc > 1.0e-6) {
        pieces.add(0, new Curve.Piece(arc, ring.sense() / ring.radiusM()));
      }
      to = from;
    }
    return new Curve(pieces);
  }
}
