package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.local.VerticalRoom;
import org.u2sa.planning.seen.GroundMap;
import org.u2sa.planning.seen.PlanningPlane;

/** Between which altitudes an aircraft 75 m high that keeps 20 m above and below may evade. */
class VerticalEvasionTest {
  private final AvoidanceBench bench =
      new AvoidanceBench(Map.of("VERTICAL CLEARANCE", 20.0, "EVASION CLIMB", 3.0));
  private final VerticalEvasion evasion =
      new VerticalEvasion(new GroundMap(Optional.empty()), bench::say);

  private Optional<Point> spot = Optional.empty();

  private VerticalRoom room() {
    Point at = Point.of(0.0, 0.0, -75.0);
    return evasion
        .room(
            bench.state,
            at,
            Point.of(8.0, 0.0, 0.0),
            Place.of(ReferenceFrame.LOCAL_NED, Point.of(8.0, 0.0, -75.0)),
            bench.settings,
            bench.world,
            bench.world.plane(bench.state),
            spot)
        .orElseThrow();
  }

  /** A corridor from the ground to 200 m. */
  private void seeCorridor() {
    bench.see(
        new Polygon()
            .points(
                List.of(
                    Point.of(-50.0, -50.0, 0.0),
                    Point.of(50.0, -50.0, 0.0),
                    Point.of(50.0, 50.0, 0.0),
                    Point.of(-50.0, 50.0, 0.0)))
            .height(200.0)
            .uid("corridor")
            .objectType("corridor")
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(-50.0)
            .y(-50.0)
            .z(-100.0));
  }

  @Test
  void room_corridorWithoutFence_isTheCorridor() {
    seeCorridor();

    assertThat(room().topDownM()).isEqualTo(-200.0);
    assertThat(room().bottomDownM()).isEqualTo(0.0);
  }

  @Test
  void room_fenceNarrowerThanTheCorridor_keepsAwayFromItsFloorAndCeiling() {
    seeCorridor();
    evasion.see(new FenceState().lowest(40.0).highest(120.0));

    assertThat(room().topDownM()).isEqualTo(-100.0);
    assertThat(room().bottomDownM()).isEqualTo(-60.0);
  }

  @Test
  void room_fenceRemoved_isTheCorridorAgain() {
    seeCorridor();
    evasion.see(new FenceState().highest(120.0));
    evasion.see(new FenceState());

    assertThat(room().topDownM()).isEqualTo(-200.0);
  }

  /** A floor is a limit, and does not say that there is no hill. */
  @Test
  void room_fenceAlone_limitsTheClimbAndAllowsNoDescent() {
    evasion.see(new FenceState().lowest(10.0).highest(120.0));

    assertThat(room().topDownM()).isEqualTo(-100.0);
    assertThat(room().bottomDownM()).isEqualTo(Double.POSITIVE_INFINITY);
  }

  /** The vehicle accelerates at 1 m/s² to its way per second, at most to 3 m/s. */
  @ParameterizedTest
  @CsvSource({"-1, 120, -115", "1, 30, -35", "-1, 120, -75"})
  void inside_climbOrDescentTowardsALimit_canAlwaysLevelOffBeforeIt(
      double sign, double limitM, double endDownM) {
    FenceState fence = new FenceState();
    evasion.see(sign < 0.0 ? fence.highest(limitM) : fence.lowest(limitM));
    double downM = -75.0;
    double mps = 0.0;
    double leastM = Double.POSITIVE_INFINITY;
    for (double t = 0.0; t < 60.0; t += 0.1) {
      double way = evasion.inside(bench.world.plane(bench.state), downM, mps, endDownM - downM);
      double wanted = Math.max(-3.0, Math.min(3.0, way));
      mps += Math.max(-0.1, Math.min(0.1, wanted - mps));
      downM += 0.1 * mps;
      double towards = Math.max(0.0, sign * mps); // as the Safety Manager predicts
      double overshootM = towards + towards * towards / (2.0 * 0.8);
      leastM = Math.min(leastM, sign * (-limitM - downM) - overshootM);
    }
    assertThat(leastM).isNotNegative();
    assertThat(downM).isCloseTo(endDownM, within(0.1));
  }

  /** 1 m above the ground, but only where it is known. */
  @Test
  void room_groundOfTheTakeOffBelow_allowsTheDescentInPlace() {
    spot = Optional.of(Point.of(1.0, 0.0, -40.0));

    assertThat(room().bottomDownM()).isEqualTo(-41.0);
    assertThat(room().ground().applyAsDouble(0.0, 0.0)).isEqualTo(-40.0);
    assertThat(room().ground().applyAsDouble(30.0, 0.0)).isEqualTo(-75.0 + room().groundM());
    assertThat(room().withoutClimb().topDownM()).isEqualTo(-75.0);
  }

  @Test
  void room_mapThatEndsAhead_allowsNoDescentBeyondIt(@TempDir Path folder) throws IOException {
    Path map = folder.resolve("map.asc");
    Files.writeString(
        map, "ncols 2\nnrows 2\nxllcenter 10\nyllcenter 50\ncellsize 0.001\n0 0\n0 0\n");
    StateInformation state = new StateInformation().x(10.0005).y(50.0005).z(75.0).psi(0.0);
    Point at = Point.of(0.0, 0.0, 0.0);

    VerticalRoom room =
        new VerticalEvasion(new GroundMap(Optional.of(HeightGrid.read(map))), bench::say)
            .room(
                state,
                at,
                Point.of(1000.0, 0.0, 0.0),
                Place.of(ReferenceFrame.GLOBAL, Point.of(10.0005, 50.01, 75.0)),
                bench.settings,
                bench.world,
                PlanningPlane.at(state),
                Optional.empty())
            .orElseThrow();

    assertThat(room.bottomDownM()).isCloseTo(55.0, within(0.01));
    assertThat(room.ground().applyAsDouble(0.0, 0.0)).isCloseTo(75.0, within(0.01));
    assertThat(room.ground().applyAsDouble(1000.0, 0.0)).isEqualTo(at.z() + room.groundM());
  }
}
