package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Plan of a run.
 *
 * @param domain kind of vehicle
 * @param home start of the run; empty for the first sample
 * @param waypoints in the order of the run
 * @param fence corners of the keep-in area; empty if none
 * @param keepOuts corners of each keep-out area of the fence
 * @param surroundings objects around the vehicle
 * @param others goals without a known position, for the map
 */
public record RunPlan(
    Domain domain,
    Optional<Start> home,
    List<Waypoint> waypoints,
    List<Corner> fence,
    List<List<Corner>> keepOuts,
    Surroundings surroundings,
    List<OtherGoal> others) {

  /**
   * A goal without a known position, e.g. an object to find.
   *
   * @param name its name
   * @param before index of the waypoint that follows it; number of waypoints if none does
   */
  public record OtherGoal(String name, int before) {}

  /** A corner of the fence [deg, east and north +]. */
  public record Corner(double longitudeDeg, double latitudeDeg) {}

  public RunPlan {
    waypoints = List.copyOf(waypoints);
    fence = List.copyOf(fence);
    keepOuts = List.copyOf(keepOuts);
    others = List.copyOf(others);
  }

  /** Creates a plan without fence and surroundings. */
  public RunPlan(Domain domain, Optional<Start> home, List<Waypoint> waypoints) {
    this(domain, home, waypoints, List.of(), List.of(), Surroundings.none(), List.of());
  }

  /** Cross-track distance of a position from a leg [m], right positive; empty if there is none. */
  public OptionalDouble crossTrackM(int leg, double longitudeDeg, double latitudeDeg) {
    if (leg < 0 || leg >= waypoints.size() || leg == 0 && home.isEmpty()) {
      return OptionalDouble.empty();
    }
    Geodetic from = leg == 0 ? home.get().onMap() : waypoints.get(leg - 1).onMap();
    Point to = from.nedOf(waypoints.get(leg).onMap());
    Point here = from.nedOf(new Geodetic(longitudeDeg, latitudeDeg, 0.0));
    double length = Math.hypot(to.x(), to.y());
    return length == 0.0
        ? OptionalDouble.empty()
        : OptionalDouble.of((to.x() * here.y() - to.y() * here.x()) / length);
  }

  /** Horizontal distance of a position from a leg's end [m]; 0 if there is no leg. */
  public double distanceM(int leg, double longitudeDeg, double latitudeDeg) {
    return leg < 0 || leg >= waypoints.size()
        ? 0.0
        : waypoints.get(leg).onMap().distanceM(new Geodetic(longitudeDeg, latitudeDeg, 0.0));
  }

  /** Path length from home past all waypoints [m]. */
  public double lengthM() {
    double length = 0.0;
    Optional<Geodetic> from = home.map(Start::onMap);
    for (Waypoint waypoint : waypoints) {
      Geodetic to = waypoint.onMap();
      length += from.map(to::distanceM).orElse(0.0);
      from = Optional.of(to);
    }
    return length;
  }

  /** Copy with a fence. */
  public RunPlan within(List<Corner> corners, List<List<Corner>> out) {
    return new RunPlan(domain, home, waypoints, corners, out, surroundings, others);
  }

  /** Copy with another waypoint at an index. */
  public RunPlan with(int index, Waypoint waypoint) {
    List<Waypoint> changed = new ArrayList<>(waypoints);
    changed.set(index, waypoint);
    return new RunPlan(domain, home, changed, fence, keepOuts, surroundings, others);
  }

  /** Copy with these capture radii of the waypoints [m], more than 0. */
  public RunPlan reachedWithin(ToDoubleFunction<Waypoint> radiusM) {
    List<Waypoint> within =
        waypoints.stream()
            .map(w -> w.within(radiusM.applyAsDouble(w), w.verticalThresholdM()))
            .toList();
    return new RunPlan(domain, home, within, fence, keepOuts, surroundings, others);
  }

  /** Copy without the waypoints that a condition excludes. */
  public RunPlan keeping(Predicate<Waypoint> condition) {
    List<OtherGoal> shifted =
        others.stream()
            .map(
                each ->
                    new OtherGoal(
                        each.name(),
                        (int) waypoints.stream().limit(each.before()).filter(condition).count()))
            .toList();
    return new RunPlan(
        domain,
        home,
        waypoints.stream().filter(condition).toList(),
        fence,
        keepOuts,
        surroundings,
        shifted);
  }

  /** Copy with goals without a known position. */
  public RunPlan with(List<OtherGoal> goals) {
    return new RunPlan(domain, home, waypoints, fence, keepOuts, surroundings, goals);
  }

  /** Copy with surroundings. */
  public RunPlan among(Surroundings around) {
    return new RunPlan(domain, home, waypoints, fence, keepOuts, around, others);
  }

  /**
   * Start of a flight, e.g. the threshold of a runway.
   *
   * @param longitudeDeg longitude, WGS-84 [deg]
   * @param latitudeDeg latitude, WGS-84 [deg]
   * @param altitudeM altitude of the ground there above mean sea level [m]
   * @param headingRad true heading of the take-off [rad], clockwise from north
   */
  public record Start(
      double longitudeDeg, double latitudeDeg, double altitudeM, double headingRad) {
    /** Its place on the ground. */
    public Geodetic place() {
      return new Geodetic(longitudeDeg, latitudeDeg, altitudeM);
    }

    /** Its place at altitude 0. */
    public Geodetic onMap() {
      return new Geodetic(longitudeDeg, latitudeDeg, 0.0);
    }
  }

  /**
   * A waypoint of the mission.
   *
   * @param name shown in tables and pictures
   * @param longitudeDeg longitude, WGS-84 [deg]
   * @param latitudeDeg latitude, WGS-84 [deg]
   * @param altitudeM altitude above mean sea level [m]; empty for any
   * @param captureRadiusM horizontal distance within which it counts as reached [m], more than 0
   * @param verticalThresholdM vertical distance within which it counts as reached [m]; empty for
   *     any
   */
  public record Waypoint(
      String name,
      double longitudeDeg,
      double latitudeDeg,
      OptionalDouble altitudeM,
      double captureRadiusM,
      OptionalDouble verticalThresholdM) {

    /**
     * @throws IllegalArgumentException if the capture radius is not a positive number
     */
    public Waypoint {
      if (!(captureRadiusM > 0.0) || Double.isInfinite(captureRadiusM)) {
        throw new IllegalArgumentException(
            "captureRadiusM of " + name + ": " + captureRadiusM + ", expected more than 0 m");
      }
    }

    /** Its place at altitude 0. */
    public Geodetic onMap() {
      return new Geodetic(longitudeDeg, latitudeDeg, 0.0);
    }

    /** Copy that counts as reached within these distances [m]. */
    public Waypoint within(double horizontalM, OptionalDouble verticalM) {
      return new Waypoint(name, longitudeDeg, latitudeDeg, altitudeM, horizontalM, verticalM);
    }
  }
}
