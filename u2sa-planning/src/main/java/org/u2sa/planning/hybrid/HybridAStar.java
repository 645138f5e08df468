package org.u2sa.planning.hybrid;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import org.u2sa.planning.curve.Curve;
import org.u2sa.planning.curve.Dubins;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.curve.ReedsShepp;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;

/**
 * Plans drivable paths through a cost grid for a vehicle with a turning circle: hybrid A* (Dolgov,
 * Thrun, Montemerlo, Diebel: Path Planning for Autonomous Vehicles in Unknown Semi-structured
 * Environments, International Journal of Robotics Research 29, 2010, section 2).
 *
 * <p>Nodes are cells of position and heading that keep the exact pose in which they were reached.
 * The heuristic is the maximum of the cost-to-go ignoring turn limits and the shortest curve
 * ignoring obstacles; occasionally that curve itself is tried as a path to the goal.
 *
 * <p>A search can be split into parts ({@link #begin}, {@link #search}), between which costs may
 * change; expanded nodes are not revisited. The order of expanded nodes does not depend on how the
 * search is split.
 *
 * <p>Not thread-safe.
 */
public final class HybridAStar {
  private static final int HEADINGS = 72;
  private static final double STEP_CELLS = 2.0;

  /** Radii from the goal within which turn limits matter to the heuristic. */
  private static final double TURNING_MATTERS = 6.0;

  /**
   * Heuristic weight: paths cost slightly more but are found much sooner (Pohl: Heuristic Search
   * Viewed as Path Finding in a Graph, Artificial Intelligence 1, 1970).
   */
  private static final double GREED = 1.3;

  /** Extra cost of a metre straight back over ground that was never seen: it may be occupied. */
  private static final double UNSEEN_PENALTY = 10.0;

  private static final double ALIGNED_RAD = Math.toRadians(5.0);

  /** Moves: curvature as a fraction of the maximum, and whether they reverse. */
  private static final double[] STEERING = {0.0, 1.0, -1.0, 0.5, -0.5};

  /**
   * Motion limits and penalties of a vehicle.
   *
   * @param radiusM minimum turn radius [m], above 0
   * @param reverses whether it can reverse
   * @param reversePenalty extra cost of a metre in reverse
   * @param switchPenaltyM cost of a change of direction [m]
   * @param turnPenalty extra cost of a metre of the tightest turn over a straight one
   * @param expansions maximum number of nodes to expand
   */
  public record Motion(
      double radiusM,
      boolean reverses,
      double reversePenalty,
      double switchPenaltyM,
      double turnPenalty,
      int expansions) {
    /** Creates a motion with the usual penalties. */
    public static Motion of(double radiusM, boolean reverses) {
      return new Motion(radiusM, reverses, 1.0, radiusM, 0.05, 200_000);
    }
  }

  /** Goal; heading is empty if it does not matter. */
  public record Goal(double northM, double eastM, OptionalDouble headingRad, double toleranceM) {}

  /** Poses on the path, including the start, and its cost [m]. */
  public record Way(Pose start, List<Curve.Sample> samples, double cost) {}

  /** A pose, and how it was reached; a better path replaces it until the node is closed. */
  private static final class Node {
    private Pose pose;
    private double cost; // [m]
    private Node parent; // null at the start
    private int move; // move from the parent: steering, or a curve to the goal
    private boolean closed;

    Node reach(Pose to, double costM, Node from, int by) {
      pose = to;
      cost = costM;
      parent = from;
      move = by;
      return this;
    }
  }

  private record Queued(Node node, double priority) {}

  private final Map<Long, Node> nodes = new HashMap<>(); // by cell of the pose
  private final PriorityQueue<Queued> open =
      new PriorityQueue<>(Comparator.comparingDouble(Queued::priority));
  private final CostToGo toGo = new CostToGo();
  private CostGrid grid;
  private BodyDiscs body;
  private double clearanceM;
  private Motion motion;
  private Goal goal;
  private Pose start;
  private double startClearanceM;
  private double stepM;
  private boolean goalOutside;
  private final List<Curve> shots = new ArrayList<>(); // moves from HEADINGS on
  private int looked; // nodes expanded since the search began
  private int nextShot;
  private Optional<Way> found = Optional.empty();

  /** Runs a whole search and returns the cheapest path found; parameters as in {@link #begin}. */
  public Optional<Way> plan(
      CostGrid costs, BodyDiscs discs, double within, Motion can, Pose from, Goal to) {
    begin(costs, discs, within, can, from, to);
    search(Integer.MAX_VALUE);
    return found;
  }

  /**
   * Starts a search and discards the previous search.
   *
   * @param within clearance of the vehicle's discs to obstacles [m]; if already closer, the current
   *     distance
   */
  public void begin(
      CostGrid costs, BodyDiscs discs, double within, Motion can, Pose from, Goal to) {
    grid = costs;
    body = discs;
    clearanceM = within;
    motion = can;
    goal = to;
    start = from;
    startClearanceM = body.clearanceM(grid, from.northM(), from.eastM(), from.headingRad());
    stepM = STEP_CELLS * grid.frame().cellM();
    goalOutside = !grid.frame().contains(to.northM(), to.eastM());
    toGo.search(grid, to.northM(), to.eastM(), to.toleranceM());
    nodes.clear();
    open.clear();
    shots.clear();
    looked = 0;
    nextShot = 0;
    found = Optional.empty();
    Node first = new Node().reach(start, 0.0, null, 0);
    nodes.put(key(start, false), first);
    open.add(new Queued(first, GREED * heuristic(start)));
  }

  /**
   * Continues the search.
   *
   * @param most maximum number of nodes to expand now
   * @return whether the search has ended: a path is {@link #found}, or there is none
   */
  public boolean search(int most) {
    int until = (int) Math.min(motion.expansions(), (long) looked + most);
    while (found.isEmpty() && !open.isEmpty() && looked < until) {
      Node node = open.remove().node();
      if (node.closed) {
        continue;
      }
      node.closed = true;
      if (node.move >= 2 * HEADINGS || isGoal(node.pose)) {
        found = Optional.of(way(node));
        return true;
      }
      looked++;
      if (looked > nextShot && !goalOutside) {
        shoot(node);
        // more often near the goal (section 2.2)
        nextShot = looked + (int) (heuristic(node.pose) / (4.0 * stepM));
      }
      expand(node);
    }
    return found.isPresent() || open.isEmpty() || isExhausted();
  }

  /** Path found by the search; empty until found, and if there is none. */
  public Optional<Way> found() {
    return found;
  }

  /** Whether the node limit was reached, so that a path may exist although none was found. */
  public boolean isExhausted() {
    return looked >= motion.expansions();
  }

  private boolean isGoal(Pose pose) {
    if (goalOutside) {
      GridFrame frame = grid.frame();
      int row = frame.row(pose.northM());
      int column = frame.column(pose.eastM());
      return row < 2 || column < 2 || row >= frame.rows() - 2 || column >= frame.columns() - 2;
    }
    return pose.distanceM(goal.northM(), goal.eastM()) <= goal.toleranceM()
        && (goal.headingRad().isEmpty()
            || Math.abs(Pose.wrapped(pose.headingRad() - goal.headingRad().getAsDouble()))
                < ALIGNED_RAD);
  }

  private void expand(Node node) {
    Pose from = node.pose;
    for (int move = 0; move < (motion.reverses() ? 2 : 1) * STEERING.length; move++) {
      boolean backwards = move >= STEERING.length;
      double curvature = STEERING[move % STEERING.length] / motion.radiusM();
      double length = backwards ? -stepM : stepM;
      Pose end = from.along(length, curvature);
      double metres = cost(from, end, length, curvature);
      if (metres == Double.POSITIVE_INFINITY) {
        continue;
      }
      boolean turnsBack = node.parent != null && backwards != node.move >= STEERING.length;
      double total = node.cost + metres + (turnsBack ? motion.switchPenaltyM() : 0.0);
      offer(end, total, node, move, backwards);
    }
  }

  private void offer(Pose to, double total, Node from, int move, boolean backwards) {
    long key = key(to, backwards);
    Node known = nodes.get(key);
    if (known != null && (known.closed || total >= known.cost - 1.0e-9)) {
      return;
    }
    double rest = heuristic(to);
    if (known == null && rest == Double.POSITIVE_INFINITY) {
      return;
    }
    Node node = known == null ? new Node() : known;
    nodes.put(key, node);
    open.add(new Queued(node.reach(to, total, from, move), total + GREED * rest));
  }

  /** Tries the shortest curve to the goal (section 2.2). */
  private void shoot(Node node) {
    Pose from = node.pose;
    Curve curve =
        goal.headingRad().isEmpty()
            ? Dubins.shortest(from, goal.northM(), goal.eastM(), motion.radiusM())
            : shortest(from);
    double metres = 0.0;
    Pose at = from;
    for (Curve.Piece piece : curve.pieces()) {
      Pose end = at.along(piece.lengthM(), piece.curvature());
      double here = cost(at, end, piece.lengthM(), piece.curvature());
      if (here == Double.POSITIVE_INFINITY) {
        return;
      }
      metres += here;
      at = end;
    }
    int move = 2 * HEADINGS + shots.size();
    shots.add(curve);
    double total = node.cost + metres;
    open.add(new Queued(new Node().reach(at, total, node, move), total));
  }

  private Curve shortest(Pose from) {
    Pose to = new Pose(goal.northM(), goal.eastM(), goal.headingRad().getAsDouble());
    return motion.reverses()
        ? ReedsShepp.shortest(from, to, motion.radiusM())
        : Dubins.shortest(from, to, motion.radiusM());
  }

  /** Cost of an arc [m]; infinite if the vehicle comes too close to something on it. */
  private double cost(Pose from, Pose end, double lengthM, double curvature) {
    int parts = Math.max(1, (int) Math.ceil(Math.abs(lengthM) / grid.frame().cellM()));
    double sum = 0.0;
    int unseen = 0;
    for (int k = 1; k <= parts; k++) {
      Pose at = k == parts ? end : from.along(lengthM * k / parts, curvature);
      double clearance = body.clearanceM(grid, at.northM(), at.eastM(), at.headingRad());
      if (clearance < required(at)) {
        return Double.POSITIVE_INFINITY;
      }
      if (lengthM < 0.0 && body.isRearUnseen(grid, at.northM(), at.eastM(), at.headingRad())) {
        unseen++;
      }
      if (unseen > 0 && curvature != 0.0) {
        return Double.POSITIVE_INFINITY; // walls beside it are as unseen
      }
      double here = grid.cost(at.northM(), at.eastM());
      sum += here == Double.POSITIVE_INFINITY ? 1.0 + grid.inflation().weight() : here;
    }
    double dislike =
        1.0
            + (lengthM < 0.0 ? motion.reversePenalty() : 0.0)
            + UNSEEN_PENALTY * unseen / parts
            + motion.turnPenalty() * Math.abs(curvature) * motion.radiusM();
    return dislike * Math.abs(lengthM) * sum / parts;
  }

  private double required(Pose at) {
    if (startClearanceM >= clearanceM) {
      return clearanceM;
    }
    boolean near = at.distanceM(start.northM(), start.eastM()) < 3.0 * body.circleM();
    return near ? Math.min(clearanceM, startClearanceM - 0.1 * grid.frame().cellM()) : clearanceM;
  }

  private double heuristic(Pose pose) {
    double around = toGo.metres(pose.northM(), pose.eastM());
    if (goalOutside || around == Double.POSITIVE_INFINITY) {
      return around;
    }
    if (pose.distanceM(goal.northM(), goal.eastM()) > TURNING_MATTERS * motion.radiusM()) {
      return around;
    }
    double turning;
    if (goal.headingRad().isPresent()) {
      Pose to = new Pose(goal.northM(), goal.eastM(), goal.headingRad().getAsDouble());
      turning =
          motion.reverses()
              ? ReedsShepp.lengthM(pose, to, motion.radiusM(), around)
              : Dubins.shortest(pose, to, motion.radiusM()).lengthM();
    } else if (motion.reverses()) {
      turning = 0.0;
    } else {
      turning =
          Dubins.shortest(pose, goal.northM(), goal.eastM(), motion.radiusM()).lengthM()
              - goal.toleranceM();
    }
    return Math.max(around, turning);
  }

  private long key(Pose pose, boolean backwards) {
    GridFrame frame = grid.frame();
    int row = Math.max(0, Math.min(frame.rows() - 1, frame.row(pose.northM())));
    int column = Math.max(0, Math.min(frame.columns() - 1, frame.column(pose.eastM())));
    double turns = pose.headingRad() / (2.0 * Math.PI);
    int heading = (int) ((turns - Math.floor(turns)) * HEADINGS) % HEADINGS;
    long cell = (long) frame.index(row, column) * HEADINGS + heading;
    return 2L * cell + (backwards ? 1L : 0L);
  }

  private Way way(Node end) {
    List<Node> chain = new ArrayList<>();
    for (Node node = end; node.parent != null; node = node.parent) {
      chain.add(node);
    }
    Collections.reverse(chain);
    List<Curve.Sample> samples = new ArrayList<>();
    Pose from = start;
    for (Node node : chain) {
      if (node.move >= 2 * HEADINGS) {
        samples.addAll(shots.get(node.move - 2 * HEADINGS).sampled(from, stepM));
      } else {
        samples.add(new Curve.Sample(node.pose, node.move >= STEERING.length));
      }
      from = node.pose;
    }
    return new Way(start, samples, end.cost);
  }
}
