package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.GroundMap;
import org.u2sa.planning.seen.PlanningPlane;

/**
 * A map that rises to the north from 0 m at the origin, by 1 m per metre, seen in a window of 20 m.
 */
class RouteGroundTest {
  private static final double CELL_DEG = 0.001;

  @TempDir Path folder;
  private final AvoidanceBench bench = new AvoidanceBench(Map.of("VERTICAL CLEARANCE", 10.0));
  private final StateInformation state = new StateInformation().x(10.0).y(0.0).z(0.0).psi(0.0);
  private final PlanningPlane plane = bench.world.plane(state);
  private RouteGround watch;

  @BeforeEach
  void start() throws IOException {
    StringBuilder text = new StringBuilder("ncols 3\nnrows 21\n");
    text.append("xllcenter 9.999\nyllcenter " + -10 * CELL_DEG + "\ncellsize " + CELL_DEG + "\n");
    for (int row = 10; row >= -10; row--) {
      double height = row * CELL_DEG * 110_574.0;
      text.append(height + " " + height + " " + height + "\n");
    }
    Path map = Files.writeString(folder.resolve("map.asc"), text);
    GroundMap ground = new GroundMap(Optional.of(HeightGrid.read(map)));
    watch = new RouteGround(ground, bench.world, () -> 0.1);
    bench.world.see(new ObjectList(), 0L);
  }

  private Optional<String> see(double upM, double northM, double climbM) {
    Point at = Point.of(0.0, 0.0, -upM);
    Point way = Point.of(northM, 0.0, -climbM);
    Optional<String> why = watch.see(plane, at, way, true, 10.0, bench.settings);
    bench.world.update(state, 0.0, 0.0, -upM, -upM - climbM);
    return why;
  }

  private boolean isFree(double northM) {
    CostGrid costs = bench.world.costs();
    return !costs.isOccupied(costs.frame().indexAt(northM, 0.0));
  }

  private boolean isBetween(double upM, double northM, double climbM) {
    Point at = Point.of(0.0, 0.0, -upM);
    return watch.isBetween(plane, at, Point.of(northM, 0.0, -climbM), 10.0, bench.settings);
  }

  @Test
  void see_levelFlight_groundLessThanTheClearanceBelowCounts() {
    assertThat(see(15.0, -50.0, 0.0)).isEmpty();

    assertThat(watch.counts()).isTrue();
    assertThat(isFree(4.5)).isTrue();
    assertThat(isFree(5.5)).isFalse();
  }

  /**
   * It is then judged as where it begins, so that it can leave, but not come lower. The ground
   * beside it, from which routes keep away, must not enclose it.
   */
  @Test
  void see_beginsLow_countsGroundThatIsNearerThanAroundTheBeginning() {
    see(9.0, -50.0, 0.0);
    assertThat(isFree(RouteGround.reachM(bench.settings) - 0.15)).isTrue();
    assertThat(isFree(RouteGround.reachM(bench.settings) + 0.15)).isFalse();

    see(4.0, -50.0, 0.0);
    assertThat(isFree(-4.0)).isFalse();
  }

  @Test
  void see_goalLow_countsGroundThatIsNearerThanAroundTheGoal() {
    see(15.0, 8.0, 0.0);

    assertThat(isFree(8.0 + RouteGround.reachM(bench.settings) - 0.15)).isTrue();
    assertThat(isFree(8.0 + RouteGround.reachM(bench.settings) + 0.15)).isFalse();
  }

  @Test
  void see_altitudeAsExpected_changesNothing() {
    see(15.0, -50.0, 0.0);
    int before = bench.world.revision();
    see(13.0, -50.0, 2.0);

    assertThat(bench.world.revision()).isEqualTo(before);
  }

  @Test
  void see_goalInTheGround_isGivenUp() {
    assertThat(see(15.0, 30.0, 0.0))
        .contains("the ground at the goal is 15 m higher than the goal");
    assertThat(see(15.0, 15.5, 0.0)).isEmpty(); // maps are not that exact
  }

  @Test
  void leave_routeEnds_noGroundCounts() {
    see(15.0, -50.0, 0.0);
    watch.leave();
    bench.world.update(state, 0.0, 0.0, -15.0, -15.0);

    assertThat(isFree(9.0)).isTrue();
    assertThat(bench.world.highGround()).isEmpty();
  }

  @Test
  void see_noClearanceSet_noGroundCounts() {
    AvoidanceBench without = new AvoidanceBench();

    watch.see(plane, Point.ORIGIN, Point.of(9.0, 0.0, 0.0), true, 10.0, without.settings);

    assertThat(watch.counts()).isFalse();
  }

  @Test
  void isBetween_straightWays_onlyThoseThroughHighGround() {
    assertThat(isBetween(30.0, 15.0, 0.0)).isFalse();
    assertThat(isBetween(30.0, 60.0, 40.0)).isTrue(); // climbs by 1 m in 10 m
    assertThat(isBetween(30.0, -100.0, 0.0)).isFalse();
  }

  /** The ground rises as far as the vehicle needs to stop. */
  @Test
  void above_fliesTowardsRisingGround_descendsOnlyToTheClearanceWhereItCanStop() {
    see(25.0, -50.0, -25.0);
    Point at = Point.of(0.0, 0.0, -25.0);

    assertThat(watch.above(at, moving(0.0), 20.0, bench.settings)).isCloseTo(15.0, within(0.1));
    assertThat(watch.above(at, moving(4.0), 20.0, bench.settings))
        .isCloseTo(15.0 - stopsM(4.0), within(1.1));
  }

  @Test
  void above_lowerThanTheClearance_climbs() {
    see(15.0, -5.0, 0.0);
    Point low = Point.of(0.0, 0.0, -7.0);

    assertThat(watch.above(low, moving(0.0), 0.0, bench.settings)).isCloseTo(-3.0, within(0.1));
  }

  @Test
  void lowestM_amongHighGround_isTheAltitudeForWhichTheRouteIsPlanned() {
    see(15.0, -100.0, -8.0);

    assertThat(watch.lowestM(-30.0, 0.0)).isCloseTo(-12.0, within(0.1)); // 0.1 of 30 m
    assertThat(watch.lowestM(-95.0, 0.0)).isGreaterThan(50.0); // near the goal, above the ground
  }

  @Test
  void lowestM_noGroundCounts_isNone() {
    watch.leave();

    assertThat(watch.lowestM(0.0, 0.0)).isInfinite();
  }

  private double stopsM(double mps) {
    AvoidanceVariables now = bench.settings;
    return mps * now.reactionTime() + mps * mps / (2.0 * now.plannedBraking());
  }

  private Vehicle moving(double northMps) {
    return Vehicle.of(
            new StateInformation().x(10.0).y(0.0).z(0.0).psi(0.0).xDot(0.0).yDot(northMps))
        .orElseThrow();
  }
}
