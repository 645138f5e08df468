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
import org.u2sa.service.U2SAService;

/**
 * A boat of 1.2 m by 0.7 m without sideways thrust, which wind and current carry and waves rock,
 * on its way past moored buoys. Scored by its true distance to them.
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
          Map.entry("STUCK AFTER", 20.0));

  private static final double STEP_S = 0.05;
  private static final double LIMIT_S = 200.0;
  private static final double BUOY_M = 0.15;
  private static final double WAY_M = 30.0;
  private static final double[] START = {0.0, 0.0};
  private static final double[][] WAYPOINTS = {{-15.0, -5.0}, {-30.0, 0.0}, {-10.0, 4.0}, {0.0, 0.0}};
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
  private double nearestM;

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void state_driftPastBuoys_arrivesWithoutContact(long seed) {
    double takes = sail(seed, true);

    assertThat(nearestM).isPositive();
    assertThat(takes).isLessThan(LIMIT_S);
  }

  /** Sails past buoys drawn from a seed, and tells how long it took [s]. */
  private double sail(long seed, boolean drifts) {
    Random random = new Random(seed * 0x9E3779B97F4A7C15L);
    random.nextLong();
    draw(random);
    BOAT.forEach(kit::with);
    U2SAService planner = kit.with("DRIFTS", drifts).start(PathPlanner::new);
    double began = kit.nowS();
    int reached = -1;
    while (kit.nowS() - began < LIMIT_S && kit.published(Channels.GOAL_REPORTS).size() < WAYPOINTS.length) {
      if (kit.published(Channels.GOAL_REPORTS).size() != reached) {
        reached = kit.published(Channels.GOAL_REPORTS).size();
        goals(waypoint("waypoint " + reached, WAYPOINTS[reached][0], WAYPOINTS[reached][1]));
      }
      kit.publish(Channels.OBJECTS, new ObjectList().objects(seen()));
      kit.publish(Channels.STATE, state());
      if (Boolean.getBoolean("trace")) System.out.printf("TR %.2f n=%.2f e=%.2f hd=%.0f v=%.2f near=%.2f dr=%.2f,%.2f%n", kit.nowS(), north, east, Math.toDegrees(heading), aheadMps, nearestM, driftNorth, driftEast);
      move(kit.latest(Channels.NAVIGATION).orElseThrow(), kit.nowS());
      kit.advance(STEP_S);
    }
    assertThat(planner.isAlive()).isTrue();
    return kit.nowS() - began;
  }

  private void draw(Random random) {
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
    nearestM = Double.POSITIVE_INFINITY;
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
  private void move(NavigationPoint point, double nowS) {
    double off = -point.point().azimuth();
    double sign = point.backwards() ? -1.0 : 1.0;
    double course = heading + off;
    double right = driftEast * Math.cos(course) - driftNorth * Math.sin(course);
    double share = Math.max(-1.0, Math.min(1.0, right / Math.max(0.3, aheadMps)));
    double crab = Math.max(-0.87, Math.min(0.87, -Math.asin(share)));
    double turn =
        point.backwards() ? Math.IEEEremainder(off + Math.PI, 2.0 * Math.PI) : off + crab;
    double wanted = Math.max(-0.44, Math.min(0.44, 1.2 * Math.IEEEremainder(turn, 2.0 * Math.PI)));
    turnRadps += Math.min(1.0, STEP_S / 0.3) * (wanted - turnRadps);
    double speed = point.speed().orElse(1.2) * sign * Math.max(0.0, sign * Math.cos(off));
    double along = driftNorth * Math.cos(heading) + driftEast * Math.sin(heading);
    double change = Math.max(-0.4 * STEP_S, Math.min(0.4 * STEP_S, speed - along - aheadMps));
    aheadMps += change;
    double wave = waveMps * Math.sin(Math.PI * nowS);
    heading = Math.IEEEremainder(heading + STEP_S * turnRadps, 2.0 * Math.PI);
    north += STEP_S * (aheadMps * Math.cos(heading) + driftNorth + wave * Math.cos(waveRad));
    east += STEP_S * (aheadMps * Math.sin(heading) + driftEast + wave * Math.sin(waveRad));
    for (double[] buoy : buoys) {
      double ahead = Math.cos(heading) * (buoy[0] - north) + Math.sin(heading) * (buoy[1] - east);
      double aside = Math.cos(heading) * (buoy[1] - east) - Math.sin(heading) * (buoy[0] - north);
      double beyond = Math.max(0.0, Math.abs(ahead) - 0.6);
      double beside = Math.max(0.0, Math.abs(aside) - 0.35);
      nearestM = Math.min(nearestM, Math.hypot(beyond, beside) - BUOY_M);
    }
  }

  @org.junit.jupiter.api.Test
  void bench() {
    int from = Integer.getInteger("bench.from", 1000);
    for (boolean drifts : new boolean[] {false, true}) {
      StringBuilder b = new StringBuilder();
      int bad = 0, late = 0;
      double sum = 0;
      for (int s = from; s < from + Integer.getInteger("bench.n", 30); s++) {
        DriftingBoatTest one = new DriftingBoatTest();
        double t = one.sail(s, drifts);
        one.close();
        if (one.nearestM <= 0) { bad++; b.append(" ").append(s); }
        if (t >= LIMIT_S) { late++; b.append(" L").append(s); }
        sum += t;
      }
      System.out.println("BENCH drifts=" + drifts + " contacts=" + bad + " late=" + late + " mean s=" + sum / Integer.getInteger("bench.n", 30) + b);
    }
  }
}
