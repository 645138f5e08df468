package org.u2sa.planning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.planning.guidance.Place;
import org.u2sa.service.U2SAService;

/**
 * Tells the operator where a flight leaves the height map of TERRAIN: the ground there is unknown,
 * and counts as free. It looks at the whole mission when it is new, at each route, and at the
 * vehicle's position.
 */
final class TerrainLimits {
  private static final double SAMPLE_M = 20.0;
  private static final int HALVINGS = 8; // of a sample, to find the edge in it
  private static final int MAX_SAMPLES = 1000; // of a way
  private static final int MAX_NAMED = 5;
  private static final int MAX_ASKED =
      20_000; // goals remembered; then they are asked for once more
  private static final String PART = "terrain"; // of the health remarks
  private static final String HOME = "home"; // UID of a mission's home
  private static final String UNKNOWN = "; ground that it does not cover counts as free";

  private final U2SAService planner;
  private final HeightGrid terrain;
  private final String file;
  private final BooleanSupplier isUsed;
  private final Set<String> asked = new HashSet<>(); // goals whose mission was asked for
  private Set<String> named = Set.of(); // goals that the last comparison of a mission named
  private String told = ""; // last comparison of a mission
  private String routeTo = ""; // UID of the last goal whose route leaves the map
  private boolean isOutside;

  /**
   * @param file name of the height map
   * @param isUsed whether the planner keeps clear of the ground
   */
  TerrainLimits(U2SAService planner, HeightGrid terrain, String file, BooleanSupplier isUsed) {
    this.planner = planner;
    this.terrain = terrain;
    this.file = file;
    this.isUsed = isUsed;
  }

  /** Request for the mission of these goals; empty if it is known. */
  Optional<MissionRequest> see(GoalList list) {
    List<String> goals =
        Stream.concat(list.goals().stream(), list.upcoming().stream())
            .map(TerrainLimits::key)
            .collect(Collectors.toList());
    if (asked.size() > MAX_ASKED) {
      asked.clear();
    }
    return isUsed.getAsBoolean() && asked.addAll(goals)
        ? Optional.of(new MissionRequest().requestId(planner.getServiceName() + " " + asked.size()))
        : Optional.empty();
  }

  /** Names the goals outside the map, and the ways that leave it. */
  void see(MissionReport mission) {
    Map<String, Geodetic> places = new HashMap<>();
    mission.goals().forEach(goal -> place(goal).ifPresent(at -> places.put(goal.uid(), at)));
    mission.goals().forEach(goal -> asked.add(key(goal)));
    List<String> order = new ArrayList<>(List.of(HOME));
    mission.sequence().stream().filter(uid -> !uid.equals(HOME)).forEach(order::add);
    order.removeIf(uid -> !places.containsKey(uid));
    Map<String, String> missing = missing(order, places);
    named = missing.keySet();
    String what = missing.isEmpty() ? "" : summary(List.copyOf(missing.values()));
    if (isUsed.getAsBoolean() && !what.isEmpty() && !what.equals(told)) {
      planner.trouble(what);
    }
    told = what;
  }

  /** By the goal's UID: what of it, or of the way to it, is not covered. */
  private Map<String, String> missing(List<String> order, Map<String, Geodetic> places) {
    Map<String, String> missing = new LinkedHashMap<>();
    String before = "";
    for (String uid : order) {
      Geodetic place = places.get(uid);
      if (!covers(place)) {
        missing.put(uid, (uid.equals(HOME) ? uid : "goal \"" + uid + "\"") + beside(place));
      } else if (!before.isEmpty() && covers(places.get(before))) {
        if (leavesAfterM(places.get(before), place).isPresent()) {
          missing.put(uid, "the way from \"" + before + "\" to \"" + uid + "\"");
        }
      }
      before = uid;
    }
    return missing;
  }

  private String summary(List<String> missing) {
    String first = missing.stream().limit(MAX_NAMED).collect(Collectors.joining(", "));
    int more = missing.size() - MAX_NAMED;
    return "TERRAIN "
        + file
        + " does not cover "
        + first
        + (more > 0 ? " and " + more + " more" : "")
        + UNKNOWN;
  }

  /** Names the goal to which a route leaves the map, once. */
  void see(PlannedPath route) {
    boolean isKnown = route.goal().equals(routeTo) || named.contains(route.goal());
    if (!isUsed.getAsBoolean()
        || isKnown
        || !route.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      return;
    }
    double wayM = 0.0;
    List<Point> points = route.points();
    for (int i = 1; i < points.size(); i++) {
      Geodetic from = onGround(points.get(i - 1));
      Geodetic to = onGround(points.get(i));
      Optional<Double> afterM = covers(from) ? leavesAfterM(from, to) : Optional.empty();
      if (afterM.isPresent()) {
        routeTo = route.goal();
        long leavesM = Math.round(wayM + afterM.get());
        planner.trouble(
            "the route to goal \""
                + routeTo
                + "\" leaves TERRAIN "
                + file
                + " after "
                + leavesM
                + " m"
                + UNKNOWN);
        return;
      }
      wayM += distanceM(from, to);
    }
  }

  /** Reports, in health too, that the vehicle is where the ground is unknown. */
  void see(Place vehicle) {
    Optional<Geodetic> place = onGround(vehicle).filter(at -> isUsed.getAsBoolean());
    boolean isNowOutside = place.isPresent() && !covers(place.get());
    if (isNowOutside == isOutside) {
      return;
    }
    isOutside = isNowOutside;
    String what =
        isOutside
            ? "the vehicle is where TERRAIN "
                + file
                + " does not cover the ground"
                + beside(place.get())
                + UNKNOWN
            : "";
    if (isOutside) {
      planner.trouble(what);
    }
    planner.remark(PART, what);
  }

  private boolean covers(Geodetic place) {
    return terrain.altitudeM(place).isPresent();
  }

  private String beside(Geodetic place) {
    double metres = terrain.outsideM(place);
    return metres > 0.0
        ? " (" + Math.max(1, Math.round(metres)) + " m beyond its edge)"
        : " (in a gap)";
  }

  /** Distance after which a straight way leaves the map [m]; empty if it does not. */
  private Optional<Double> leavesAfterM(Geodetic from, Geodetic to) {
    Point way = from.nedOf(to);
    double lengthM = Math.hypot(way.x(), way.y());
    int samples = (int) Math.min(MAX_SAMPLES, Math.ceil(lengthM / SAMPLE_M));
    for (int i = 1; i <= samples; i++) {
      double share = (double) i / samples;
      if (!covers(from.fromNed(along(way, share)))) {
        return Optional.of(lengthM * edge(from, way, share - 1.0 / samples, share));
      }
    }
    return Optional.empty();
  }

  /** Share of a way at which the map ends between two others (bisection). */
  private double edge(Geodetic from, Point way, double inside, double outside) {
    double in = inside;
    double out = outside;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (in + out) / 2.0;
      boolean isIn = covers(from.fromNed(along(way, middle)));
      in = isIn ? middle : in;
      out = isIn ? out : middle;
    }
    return out;
  }

  private static Point along(Point way, double share) {
    return Point.of(share * way.x(), share * way.y(), 0.0);
  }

  private static double distanceM(Geodetic from, Geodetic to) {
    Point way = from.nedOf(to);
    return Math.hypot(way.x(), way.y());
  }

  private static String key(GoalInformation goal) {
    return goal.uid() + place(goal).map(at -> " " + at).orElse("");
  }

  private static Optional<Geodetic> place(GoalInformation goal) {
    boolean isOnEarth = goal instanceof Waypoint at && at.referenceFrame().isEarth();
    return isOnEarth ? onGround(Place.of((Waypoint) goal)) : Optional.empty();
  }

  private static Optional<Geodetic> onGround(Place place) {
    return place.onEarth() && place.isHorizontal()
        ? Optional.of(new Geodetic(place.x().orElseThrow(), place.y().orElseThrow(), 0.0))
        : Optional.empty();
  }

  private static Geodetic onGround(Point global) {
    return new Geodetic(global.x(), global.y(), 0.0);
  }
}
