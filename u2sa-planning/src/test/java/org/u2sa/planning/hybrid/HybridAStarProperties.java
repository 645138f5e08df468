package org.u2sa.planning.hybrid;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.curve.Curve;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;

/** Ways among discs, checked with the vehicle's rectangle against the discs themselves. */
class HybridAStarProperties {
  private static final double SIDE = 12.0;
  private static final double CELL = 0.2;
  private static final double FRONT = 0.5;
  private static final double REAR = 0.1;
  private static final double WIDTH = 0.4;
  private static final double RADIUS = 1.0;
  private static final double CLEARANCE = 0.2;
  private static final BodyDiscs BODY = new BodyDiscs(FRONT, REAR, WIDTH);

  private record Disc(double north, double east, double radius) {}

  @Property(tries = 60)
  void plan_randomDiscs_endsAtTheGoalTurnsNoTighterAndTouchesNothing(@ForAll long seed) {
    Random random = new Random(seed);
    boolean reverses = random.nextBoolean();
    Pose start = new Pose(1.5, 1.5, 2.0 * Math.PI * random.nextDouble());
    OptionalDouble heading =
        random.nextBoolean()
            ? OptionalDouble.of(2.0 * Math.PI * random.nextDouble())
            : OptionalDouble.empty();
    List<Disc> discs = discs(random, 6);

    Optional<HybridAStar.Way> way = plan(discs, start, heading, reverses, 20_000);

    way.ifPresent(found -> assertObeys(found, start, heading, reverses, discs));
  }

  @Property(tries = 20)
  void plan_nothingInTheWay_findsAWay(@ForAll long seed) {
    Random random = new Random(seed);
    Pose start = new Pose(3.0, 3.0, 2.0 * Math.PI * random.nextDouble());

    assertThat(plan(List.of(), start, OptionalDouble.empty(), false, 200_000)).isPresent();
    assertThat(plan(List.of(), start, OptionalDouble.of(0.0), true, 200_000)).isPresent();
  }

  @Test
  void plan_noseAgainstAWall_backsOff() {
    List<Disc> wall = new ArrayList<>();
    for (double east = 0.0; east < 4.0; east += 0.2) {
      wall.add(new Disc(2.5, east, 0.2));
    }
    Pose start = new Pose(1.5, 1.5, 0.0);

    HybridAStar.Way way = plan(wall, start, OptionalDouble.empty(), true, 200_000).orElseThrow();

    assertObeys(way, start, OptionalDouble.empty(), true, wall);
    assertThat(way.samples()).anyMatch(Curve.Sample::backwards);
  }

  @Test
  void plan_goalBehind_backsOverGroundThatWasSeenOnly() {
    assertThat(backwardsM(false)).isGreaterThan(2.0);
    assertThat(backwardsM(true)).isLessThan(1.0);
  }

  /** It starts in a dead end: there is no other way than back. */
  @Test
  void plan_deadEndAndNothingSeenBehind_backsOutStraight() {
    GridFrame frame = new GridFrame(0.0, 0.0, CELL, 60, 60);
    CostGrid costs = new CostGrid(frame, new Inflation(0.4, 0.9, 3.0));
    costs.update(
        i -> frame.centreNorthM(i) > 7.2 && frame.centreNorthM(i) < 7.6,
        i -> frame.centreNorthM(i) < 6.2);
    HybridAStar.Goal goal = new HybridAStar.Goal(3.0, 8.0, OptionalDouble.empty(), 0.4);
    HybridAStar.Way way =
        new HybridAStar()
            .plan(
                costs,
                BODY,
                CLEARANCE,
                HybridAStar.Motion.of(RADIUS, true),
                new Pose(6.0, 6.0, 0.0),
                goal)
            .orElseThrow();

    assertThat(way.samples())
        .filteredOn(Curve.Sample::backwards)
        .isNotEmpty()
        .allMatch(sample -> Math.abs(Pose.wrapped(sample.pose().headingRad())) < 1.0e-9);
  }

  /** Length of the way in reverse to a goal 3 m behind [m]. */
  private static double backwardsM(boolean unseen) {
    GridFrame frame = new GridFrame(0.0, 0.0, CELL, 60, 60);
    CostGrid costs = new CostGrid(frame, new Inflation(0.4, 0.9, 3.0));
    costs.update(i -> false, i -> unseen && frame.centreNorthM(i) < 6.0);
    HybridAStar.Motion motion = HybridAStar.Motion.of(RADIUS, true);
    HybridAStar.Goal goal = new HybridAStar.Goal(3.0, 6.0, OptionalDouble.empty(), 0.4);
    HybridAStar.Way way =
        new HybridAStar()
            .plan(costs, BODY, CLEARANCE, motion, new Pose(6.0, 6.0, 0.0), goal)
            .orElseThrow();
    double metres = 0.0;
    Pose last = way.start();
    for (Curve.Sample sample : way.samples()) {
      metres += sample.backwards() ? sample.pose().distanceM(last.northM(), last.eastM()) : 0.0;
      last = sample.pose();
    }
    return metres;
  }

  private static Optional<HybridAStar.Way> plan(
      List<Disc> discs, Pose start, OptionalDouble heading, boolean reverses, int expansions) {
    int cells = (int) Math.round(SIDE / CELL);
    GridFrame frame = new GridFrame(0.0, 0.0, CELL, cells, cells);
    double keeps = BODY.radiusM() + CLEARANCE;
    CostGrid costs = new CostGrid(frame, new Inflation(keeps, keeps + 0.5, 3.0));
    costs.update(
        i ->
            discs.stream()
                .anyMatch(
                    disc ->
                        Math.hypot(
                                frame.centreNorthM(i) - disc.north(),
                                frame.centreEastM(i) - disc.east())
                            <= disc.radius() + 0.5 * CELL),
        i -> false);
    HybridAStar.Motion motion =
        new HybridAStar.Motion(RADIUS, reverses, 1.0, RADIUS, 0.05, expansions);
    return new HybridAStar()
        .plan(
            costs, BODY, CLEARANCE, motion, start, new HybridAStar.Goal(10.0, 10.0, heading, 0.4));
  }

  private static void assertObeys(
      HybridAStar.Way way, Pose start, OptionalDouble heading, boolean reverses, List<Disc> discs) {
    assertThat(way.start()).isEqualTo(start);
    Pose before = start;
    double length = 0.0;
    for (Curve.Sample sample : way.samples()) {
      Pose now = sample.pose();
      double chord = before.distanceM(now.northM(), now.eastM());
      double turned = Math.abs(Pose.wrapped(now.headingRad() - before.headingRad()));
      // chord of an arc: 2 R sin(angle / 2)
      double tightest = 2.0 * RADIUS * Math.sin(0.5 * turned);
      assertThat(chord).as("chord of a turn by %s", turned).isGreaterThan(tightest - 1e-6);
      double ahead =
          (now.northM() - before.northM()) * Math.cos(before.headingRad())
              + (now.eastM() - before.eastM()) * Math.sin(before.headingRad());
      assertThat(sample.backwards() ? -ahead : ahead).as("direction").isGreaterThan(-1e-6);
      assertThat(reverses || !sample.backwards()).isTrue();
      for (Disc disc : discs) {
        assertThat(distanceM(now, disc)).isGreaterThan(0.0);
      }
      length += chord;
      before = now;
    }
    assertThat(before.distanceM(10.0, 10.0)).isLessThanOrEqualTo(0.4 + 1e-6);
    assertThat(way.cost()).isGreaterThanOrEqualTo(length - 1e-6);
    if (heading.isPresent()) {
      assertThat(Math.abs(Pose.wrapped(before.headingRad() - heading.getAsDouble())))
          .isLessThan(Math.toRadians(5.0));
    }
  }

  /** From the vehicle's rectangle to the disc [m]; 0 or less if they touch. */
  private static double distanceM(Pose at, Disc disc) {
    double dn = disc.north() - at.northM();
    double de = disc.east() - at.eastM();
    double ahead = dn * Math.cos(at.headingRad()) + de * Math.sin(at.headingRad());
    double right = de * Math.cos(at.headingRad()) - dn * Math.sin(at.headingRad());
    double beyond = Math.max(0.0, Math.max(ahead - FRONT, -REAR - ahead));
    return Math.hypot(beyond, Math.max(0.0, Math.abs(right) - 0.5 * WIDTH)) - disc.radius();
  }

  /** Discs that leave start and goal free. */
  private static List<Disc> discs(Random random, int most) {
    List<Disc> discs = new ArrayList<>();
    int count = random.nextInt(most + 1);
    while (discs.size() < count) {
      Disc disc =
          new Disc(
              SIDE * random.nextDouble(),
              SIDE * random.nextDouble(),
              0.3 + 0.9 * random.nextDouble());
      boolean free =
          Math.hypot(disc.north() - 1.5, disc.east() - 1.5) > disc.radius() + 1.3
              && Math.hypot(disc.north() - 10.0, disc.east() - 10.0) > disc.radius() + 1.3;
      if (free) {
        discs.add(disc);
      }
    }
    return discs;
  }
}
