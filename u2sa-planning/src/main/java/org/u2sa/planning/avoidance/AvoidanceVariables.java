package org.u2sa.planning.avoidance;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.PathPlanner;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.seen.SeenWorld;

/** Obstacle-avoidance variables of a {@link PathPlanner}; used if PLANNER is not NONE. */
public record AvoidanceVariables(
    @Variable(unit = "m", min = 0, ifAbsent = 0.3)
        @Description("Distance from the vehicle's reference point to its front.")
        double vehicleFront,
    @Variable(unit = "m", min = 0, ifAbsent = 0.3)
        @Description("Distance from the vehicle's reference point to its rear.")
        double vehicleRear,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 0.5)
        @Description("Width of the vehicle, or span.")
        double vehicleWidth,
    @Variable(unit = "m", min = 0, ifAbsent = 0.2)
        @Description("Distance that routes keep between the vehicle and obstacles.")
        double clearance,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description(
            "Distance from obstacles within which the vehicle does not cut corners of its route but follows it closely and more slowly; 0: corners are cut as far as obstacles allow.")
        double preferredClearance,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description(
            "Narrowest passage on the map that routes lead straight through, for vehicles that turn in place. 0: wide enough to turn in or, if no other route leads to the goal, VEHICLE WIDTH plus CLEARANCE.")
        double narrowestPassage,
    @Variable(unit = "m", min = 0, ifAbsent = 1)
        @Description("Beyond CLEARANCE, distance from obstacles up to which routes cost more.")
        double inflation,
    @Variable(min = 0, max = 100, ifAbsent = 3)
        @Description("Extra cost per metre at CLEARANCE from an obstacle, relative to open space.")
        double inflationCost,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 0.1)
        @Description("Cell of the grid on which routes are planned.")
        double planningCell,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description(
            "Like PLANNING CELL, for routes through passages too narrow to turn in, because coarse cells make passages narrower; 0: PLANNING CELL.")
        double narrowCell,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 40)
        @Description("Edge of the square around the vehicle within which routes avoid obstacles.")
        double planningSpan,
    @Variable(ifAbsentText = "corridor")
        @Description(
            "Type of the objects, each overlapping the next, that form the area to stay inside.")
        String corridorType,
    @Variable(ifAbsentText = "")
        @Description("Types of objects that are not obstacles, separated by commas.")
        String ignoredTypes,
    @Variable(ifAbsentText = "")
        @Description(
            "Types of objects to pass on one side, such as red flag: LEFT, blue flag: RIGHT; the other side is blocked unless no other route exists (OVERLOOK AFTER).")
        String passSides,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 2.5)
        @Description("Lateral distance up to which the other side of such an object is blocked.")
        double passReach,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description("Objects farther above or below are ignored; 0: heights do not matter.")
        double verticalClearance,
    @Variable(unit = "m/s", min = 0, ifAbsent = 0)
        @Description(
            "Rate at which the vehicle climbs or descends to evade traffic, if VERTICAL CLEARANCE is set; 0: it evades at the altitude of its goal.")
        double evasionClimb,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description(
            "At a waypoint reached between two lines within this distance, the way back is blocked until the next waypoint, or until no other route exists (OVERLOOK AFTER); 0: never.")
        double closeBehind,
    @Variable(unit = "m/s", min = 0, minExcluded = true, ifAbsent = 1)
        @Description("Speed around obstacles, unless the waypoint sets one.")
        double plannedSpeed,
    @Variable(unit = "m/s", min = 0, ifAbsent = 0)
        @Description("Minimum speed; above 0 for a vehicle that cannot stop, such as an aeroplane.")
        double minSpeed,
    @Variable(unit = "m/s", min = 0, ifAbsent = 0)
        @Description("Maximum speed to arrive at a waypoint in time; 0: PLANNED SPEED.")
        double maxSpeed,
    @Variable(unit = "m/s^2", min = 0, minExcluded = true, ifAbsent = 0.8)
        @Description("Acceleration that the control system achieves.")
        double plannedAcceleration,
    @Variable(unit = "m/s^2", min = 0, minExcluded = true, ifAbsent = 1)
        @Description("Deceleration that the control system achieves.")
        double plannedBraking,
    @Variable(unit = "s", min = 0, ifAbsent = 0.3)
        @Description("Delay from a navigation point until the vehicle moves accordingly.")
        double reactionTime,
    @Variable(unit = "deg/s", min = 0, minExcluded = true, ifAbsent = 45)
        @Description("Yaw rate that the control system achieves in turns in place.")
        double plannedTurnRate,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description("Minimum turn radius; 0: derived from TURN ACCELERATION, or turns in place.")
        double turnRadius,
    @Variable(ifAbsentText = "false")
        @Description("Whether the control system can drive backwards.")
        boolean reverses,
    @Variable(unit = "m/s", min = 0, ifAbsent = 0)
        @Description(
            "Maximum speed in reverse; 0: as forwards. Where no sensor looks backwards, it limits how hard the vehicle hits what came there.")
        double reverseSpeed,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether wind and current carry the vehicle sideways, like a boat without lateral thrust: the planner then estimates the drift and predicts how the vehicle is steered against it.")
        boolean drifts,
    @Variable(unit = "m", min = 0, ifAbsent = 0.3)
        @Description("Distance to keep from traffic, beyond its own radius and the vehicle's.")
        double trafficClearance,
    @Variable(unit = "s", min = 0, ifAbsent = 4) @Description("Time horizon for avoiding traffic.")
        double trafficHorizon,
    @Variable(unit = "deg", min = 0, minExcluded = true, max = 180, ifAbsent = 10)
        @Description("Heading tolerance at waypoints.")
        double arrivalAngle,
    @Variable(unit = "s", min = 0, minExcluded = true, ifAbsent = 0.5)
        @Description("Interval between searches for a better route.")
        double replanInterval,
    @Variable(min = 100, max = 1_000_000, ifAbsent = 2000)
        @Description(
            "Nodes that HYBRID searches per state, five times as many if the vehicle cannot stop; a longer search continues with the next state.")
        int planningEffort,
    @Variable(unit = "s", min = 0, minExcluded = true, ifAbsent = 6)
        @Description("Time without progress after which the vehicle frees itself.")
        double stuckAfter,
    @Variable(min = 0, max = 100, ifAbsent = 4)
        @Description("Attempts to free itself before it gives up a goal.")
        int recoveries,
    @Variable(unit = "s", min = 0, minExcluded = true, ifAbsent = 20)
        @Description("Time without any route after which a goal is given up.")
        double giveUpAfter,
    @Variable(unit = "s", min = 0, ifAbsent = 0)
        @Description(
            "Time without any route after which obstacles with a confidence below 0.6 are ignored, until a route has existed for the same time; 0: never.")
        double overlookAfter,
    @Variable(unit = "s", min = 0, minExcluded = true, ifAbsent = 2)
        @Description(
            "Age of the World Modeler's newest objects, or of its newest grid if it publishes no objects, at which the vehicle stops, or circles if it cannot stop, until newer data arrive. Not with PLANNER = NONE.")
        double worldStaleAfter) {
  /** Collision distance to an obstacle, allowing for rounding [fraction of a cell]. */
  private static final double TOUCH_CELLS = 0.5;

  private static final double COVER_CELLS = 1.5; // spacing of discs that closely cover the vehicle
  private static final int EFFORTS_IN_FLIGHT = 5;
  private static final double OCCUPIED_ABOVE = 0.65; // probability of a cell of the grid

  public AvoidanceVariables {
    PassSides.parse(passSides);
  }

  /** Shape of the vehicle, including corners if passages may be barely wider than it. */
  BodyDiscs body(boolean closely) {
    return closely || narrowestPassage > 0.0
        ? BodyDiscs.closely(
            vehicleFront,
            vehicleRear,
            vehicleWidth,
            COVER_CELLS * Math.min(planningCell, cellM(true)))
        : new BodyDiscs(vehicleFront, vehicleRear, vehicleWidth);
  }

  /**
   * Settings for reading the world, for a vehicle that can or cannot turn in place.
   *
   * @param narrow whether routes may use every passage that the vehicle fits through
   */
  SeenWorld.Reading reading(boolean onTheSpot, boolean narrow) {
    boolean isNarrow = narrow || onTheSpot && narrowestPassage > 0.0;
    double radius = onTheSpot ? turningM() : body(false).radiusM() + clearance;
    if (isNarrow) {
      double halfM = onTheSpot ? 0.5 * passageM() : 0.5 * vehicleWidth + clearance;
      radius = Math.min(radius, halfM);
    }
    double cellM = cellM(isNarrow);
    return new SeenWorld.Reading(
        cellM,
        planningSpan,
        new Inflation(radius, radius + Math.max(inflation, cellM), inflationCost),
        OCCUPIED_ABOVE,
        corridorType,
        types(),
        verticalClearance,
        stops() && verticalClearance > 0.0
            ? body(onTheSpot).circleM() + touchM(cellM) + cellM
            : 0.0);
  }

  /** Whether some passages are wide enough to pass but not to turn in; used as a last resort. */
  boolean hasNarrower() {
    return narrowestPassage == 0.0 && 0.5 * passageM() < turningM();
  }

  private double cellM(boolean narrow) {
    return narrow && narrowCell > 0.0 ? narrowCell : planningCell;
  }

  private double turningM() {
    return body(true).circleM() + clearance;
  }

  private double passageM() {
    return narrowestPassage > 0.0
        ? Math.max(vehicleWidth, narrowestPassage)
        : vehicleWidth + clearance;
  }

  private List<String> types() {
    return Arrays.stream(ignoredTypes.split(","))
        .map(String::trim)
        .filter(type -> !type.isEmpty())
        .collect(Collectors.toList());
  }

  /** Collision distance to an obstacle, for cells of this size [m]. */
  double touchM(double cellM) {
    return Math.min(0.5 * clearance, TOUCH_CELLS * cellM);
  }

  public boolean stops() {
    return minSpeed == 0.0;
  }

  /** Nodes to search per state; more for vehicles that cannot stop and need their route sooner. */
  int effort() {
    return stops() ? planningEffort : EFFORTS_IN_FLIGHT * planningEffort;
  }

  /** {@link #worldStaleAfter} [µs]. */
  public long worldStaleMicros() {
    return Clock.micros(worldStaleAfter);
  }

  long replanMicros() {
    return Clock.micros(replanInterval);
  }

  long stuckMicros() {
    return Clock.micros(stuckAfter);
  }

  long overlookMicros() {
    return Clock.micros(overlookAfter);
  }

  /** Time without progress after which a goal is abandoned [µs]. */
  public long giveUpMicros() {
    return Clock.micros(giveUpAfter);
  }

  /** Maximum speed in reverse [m/s]; 0 if it cannot reverse. */
  double backwardsMps() {
    if (!reverses) {
      return 0.0;
    }
    return reverseSpeed == 0.0 ? Double.POSITIVE_INFINITY : reverseSpeed;
  }
}
