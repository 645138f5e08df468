package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;

/**
 * A boat of 1.2 m by 0.7 m without sideways thrust, which wind and current carry and waves rock, on
 * its way past moored buoys. Scored by its true distance to them.
 */
class DriftingBoatTest extends PlannedVehicle {
  private static final Map<String, Object> BOAT =
      Map.ofEntries(
          Map.entry("PLANNER", "GRID"),
          Map.entry("LOOK AHEAD", 4.0),
          Map.entry("TURN ACCELERATION", 0.0),
          Map.entry("VEHICLE FRONT", 0.6),
          Map.entry("VEHICLE REAR", 0.6),
          Map.entry("VEHICLE WIDTH", 0.7),
          Map.entry("CLEARANCE", 0.8),
          Map.entry("PLANNING CELL", 0.2),
          Map.entry("PLANNED SPEED", 1.2),
          Map.entry("PLANNED ACCELERATION", 0.5),
          Map.entry("PLANNED BRAKING", 0.4),
          Map.entry("PLANNED TURN RATE", 25.0),
          Map.entry("REACTION TIME", 0.5),
          Map.entry("REVERSES", true),
          Map.entry("DRIFTS", true),
          Map.entry("STUCK AFTER", 20.0));

  private static final double STEP_S = 0.05;
  private static final double LIMIT_S = 200.0;
  private static final double BUOY_M = 0.15;
  private static final double WAY_M = 30.0;
  private static final double[] START = {0.0, 0.0};
  private static final double[][] WAYPOINTS = {
    {-15.0, -5.0}, {-30.0, 0.0}, {-10.0, 4.0}, {0.0, 0.0}
  };
  private static final int BUOYS = 16;
  private static final double APART_M = 3.5;

  private final List<double[]> buoys = new ArrayList<>();
  private double north;
  private double east;
  private double heading;
  private double turnRadps;
  private double aheadMps; // through the water
  private double driftNorth;
  private double driftEast;
  private double waveMps;
  private double waveRad;
  private double nearestM = Double.POSITIVE_INFINITY; // of the hull to a buoy

  /** Without DRIFTS it touches a buoy with each of these. */
  @ParameterizedTest
  @ValueSource(longs = {1006, 1022, 1024, 1036, 2012, 2024})
  void state_driftPastBuoys_arrivesWithoutContact(long seed) {
    draw(new Random(seed * 0x9E3779B97F4A7C15L));
    BOAT.forEach(kit::with);
    kit.start(PathPlanner::new);
    double limitS = kit.nowS() + LIMIT_S;

    int reached = -1;
    while (reached < WAYPOINTS.length && kit.nowS() < limitS) {
      int reports = kit.published(Channels.GOAL_REPORTS).size();
      if (reports > reached && reports < WAYPOINTS.length) {
        goals(waypoint("waypoint " + reports, WAYPOINTS[reports][0], WAYPOINTS[reports][1]));
      }
      reached = reports;
      kit.publish(Channels.OBJECTS, new ObjectList().objects(seen()));
      kit.publish(Channels.STATE, state());
      move(kit.latest(Channels.NAVIGATION).orElseThrow());
      kit.advance(STEP_S);
    }

    assertThat(reached).isEqualTo(WAYPOINTS.length);
    assertThat(nearestM).isPositive();
  }

  private void draw(Random random) {
    random.nextLong(); // the first numbers of neighbouring seeds are alike
    double driftMps = 0.2 + 0.3 * random.nextDouble();
    double towards = 2.0 * Math.PI * random.nextDouble();
    driftNorth = driftMps * Math.cos(towards);
    driftEast = driftMps * Math.sin(towards);
    waveMps = 0.3 * random.nextDouble();
    waveRad = towards + random.nextDouble() - 0.5;
    heading = 2.0 * Math.PI * random.nextDouble();
    while (buoys.size() < BUOYS) {
      double[] buoy = {-WAY_M * random.nextDouble(), 12.0 * random.nextDouble() - 6.0};
      if (buoys.stream().allMatch(other -> away(other, buoy) > APART_M)
          && away(START, buoy) > 4.0
          && Stream.of(WAYPOINTS).allMatch(place -> away(place, buoy) > 3.0)) {
        buoys.add(buoy);
      }
    }
  }

  private static double away(double[] one, double[] other) {
    return Math.hypot(one[0] - other[0], one[1] - other[1]);
  }

  private List<ObjectDescription> seen() {
    List<ObjectDescription> seen = new ArrayList<>();
    for (double[] buoy : buoys) {
      seen.add(
          new Circle()
              .radius(BUOY_M)
              .uid("buoy " + seen.size())
              .referenceFrame(ReferenceFrame.LOCAL_NED)
              .x(buoy[0])
              .y(buoy[1]));
    }
    return seen;
  }

  private StateInformation state() {
    double wave = waveMps * Math.sin(Math.PI * kit.nowS());
    return state(north, east, heading)
        .psiDot(turnRadps)
        .xDot(aheadMps * Math.cos(heading) + driftNorth + wave * Math.cos(waveRad))
        .yDot(aheadMps * Math.sin(heading) + driftEast + wave * Math.sin(waveRad));
  }

  /** As AllocatingControl with FACES THE WAY and COUNTERS DRIFT. */
  private void move(NavigationPoint point) {
    double off = -point.point().azimuth();
    double sign = point.backwards() ? -1.0 : 1.0;
    double course = heading + off;
    double right = driftEast * Math.cos(course) - driftNorth * Math.sin(course);
    double share = Math.max(-1.0, Math.min(1.0, right / Math.max(0.3, aheadMps)));
    double crab = Math.max(-0.87, Math.min(0.87, -Math.asin(share)));
    double turn = point.backwards() ? Math.IEEEremainder(off + Math.PI, 2.0 * Math.PI) : off + crab;
    double wanted = Math.max(-0.44, Math.min(0.44, 1.2 * Math.IEEEremainder(turn, 2.0 * Math.PI)));
    turnRadps += Math.min(1.0, STEP_S / 0.3) * (wanted - turnRadps);
    double speed = point.speed().orElse(1.2) * sign * Math.max(0.0, sign * Math.cos(off));
    double along = driftNorth * Math.cos(heading) + driftEast * Math.sin(heading);
    double change = Math.max(-0.4 * STEP_S, Math.min(0.4 * STEP_S, speed - along - aheadMps));
    aheadMps += change;
    heading = Math.IEEEremainder(heading + STEP_S * turnRadps, 2.0 * Math.PI);
    StateInformation now = state();
    north += STEP_S * now.xDot().orElseThrow();
    east += STEP_S * now.yDot().orElseThrow();
    for (double[] buoy : buoys) {
      double ahead = Math.cos(heading) * (buoy[0] - north) + Math.sin(heading) * (buoy[1] - east);
      double aside = Math.cos(heading) * (buoy[1] - east) - Math.sin(heading) * (buoy[0] - north);
      double beyond = Math.max(0.0, Math.abs(ahead) - 0.6);
      double beside = Math.max(0.0, Math.abs(aside) - 0.35);
      nearestM = Math.min(nearestM, Math.hypot(beyond, beside) - BUOY_M);
    }
  }
}
