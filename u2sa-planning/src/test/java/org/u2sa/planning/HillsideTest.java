package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FenceState;

/**
 * A multirotor that TERRAIN shows to be low above uneven ground, on its way to a goal without
 * altitude, such as home on a RETURN, or to one that is as low.
 */
class HillsideTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;
  private static final double WAY_M = 70.0;
  private static final double FAR_M = 120.0; // to a goal outside PLANNING SPAN
  private static final double CLEARANCE_M = 5.0;

  @TempDir Path folder;
  private final Multirotor vehicle = new Multirotor();
  private DoubleBinaryOperator ground = (north, east) -> 0.0;
  private double spanM = 160.0; // edge of the planned area
  private double lowestM = Double.POSITIVE_INFINITY; // above the ground, while it moves sideways

  /** Obeys at once. */
  private static final class Multirotor extends TestVehicle {
    private double climbMps;
    private double asideMps;

    @Override
    void step(double dtS, Optional<NavigationPoint> point) {
      if (point.isEmpty()) {
        return;
      }
      Point ned = new Attitude(0.0, 0.0, heading).nedOf(point.get().point());
      double away = Math.max(1.0, Math.hypot(ned.x(), ned.y()));
      double share = Math.min(5.0, point.get().speed().orElse(5.0)) / away;
      asideMps = share * Math.hypot(ned.x(), ned.y());
      north += share * dtS * ned.x();
      east += share * dtS * ned.y();
      climbMps = Math.max(-2.0, Math.min(2.0, -ned.z()));
      altitude += dtS * climbMps;
    }

    @Override
    StateInformation state() {
      return super.state().zDot(climbMps);
    }
  }

  private void start(double aboveM, DoubleBinaryOperator heights) throws IOException {
    ground = heights;
    int cells = 401;
    double cellDeg = 0.00002;
    double west = TestVehicle.ORIGIN.longitudeDeg() - cells / 2 * cellDeg;
    double south = TestVehicle.ORIGIN.latitudeDeg() - cells / 2 * cellDeg;
    StringBuilder text = new StringBuilder("ncols " + cells + "\nnrows " + cells + "\n");
    text.append("xllcenter " + west + "\nyllcenter " + south + "\ncellsize " + cellDeg + "\n");
    for (int row = cells - 1; row >= 0; row--) {
      for (int column = 0; column < cells; column++) {
        Geodetic place = new Geodetic(west + column * cellDeg, south + row * cellDeg, 0.0);
        Point ned = TestVehicle.ORIGIN.nedOf(place);
        text.append(String.format(Locale.ROOT, "%.2f ", heights.applyAsDouble(ned.x(), ned.y())));
      }
      text.append('\n');
    }
    Path map = Files.writeString(folder.resolve("ground.asc"), text);
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", CLEARANCE_M).with("EVASION CLIMB", 2.0);
    kit.with("VEHICLE FRONT", 0.5).with("VEHICLE REAR", 0.5).with("VEHICLE WIDTH", 1.0);
    kit.with("CLEARANCE", 3.0).with("INFLATION", 6.0).with("PLANNING CELL", 1.0);
    kit.with("PLANNING SPAN", spanM).with("LOOK AHEAD", 8.0).with("PLANNED SPEED", 5.0);
    kit.with("GIVE UP AFTER", 10.0).with("STUCK AFTER", 20.0).with("TERRAIN", map.toString());
    kit.start(PathPlanner::new);
    vehicle.altitude = heights.applyAsDouble(0.0, 0.0) + aboveM;
  }

  private Waypoint north(double wayM) {
    Geodetic place = TestVehicle.ORIGIN.fromNed(Point.of(wayM, 0.0, 0.0));
    Waypoint goal = new Waypoint().horizontalThreshold(2.0);
    goal.uid("home").referenceFrame(ReferenceFrame.GLOBAL);
    return goal.x(place.longitudeDeg()).y(place.latitudeDeg());
  }

  private GoalInformation fly(double limitS) {
    while (kit.nowS() < limitS && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
      kit.publish(Channels.STATE, vehicle.state());
      vehicle.step(STEP_S, kit.latest(Channels.NAVIGATION));
      if (vehicle.asideMps > 0.5) {
        lowestM = Math.min(lowestM, vehicle.altitude - groundM());
      }
      kit.advance(STEP_S);
    }
    return kit.latest(Channels.GOAL_REPORTS).orElseThrow();
  }

  private double groundM() {
    return ground.applyAsDouble(vehicle.north, vehicle.east);
  }

  /** Home is downhill, uphill and across. */
  @ParameterizedTest
  @CsvSource({
    "2, -0.1, 0",
    "4, -0.1, 0",
    "4, -0.4, 0",
    "8, -0.4, 0",
    "4, 0.1, 0",
    "2, 0.4, 0",
    "9, 0.4, 0",
    "15, 0.3, 0",
    "2, 0, 0.4",
    "4, 0, 0.1",
    "0.3, 0.1, 0.1",
    "3, 0.03, 0"
  })
  void home_lowAboveASlope_isReached(double aboveM, double northward, double eastward)
      throws IOException {
    start(aboveM, (north, east) -> northward * north + eastward * east);
    goals(north(WAY_M));

    assertThat(fly(60.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(Math.min(aboveM, CLEARANCE_M) - 1.0).isGreaterThan(1.5);
    assertThat(vehicle.altitude - groundM()).isGreaterThan(CLEARANCE_M - 0.5);
  }

  @Test
  void home_outOfAHollow_isReached() throws IOException {
    start(3.0, (north, east) -> -12.0 * Math.exp(-(north * north + east * east) / 324.0));
    goals(north(WAY_M));

    assertThat(fly(60.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(2.0);
  }

  /** The ridge is longer than the area for which routes are planned. */
  @Test
  void home_behindARidge_climbsOverIt() throws IOException {
    start(4.0, (north, east) -> 40.0 * Math.exp(-Math.pow((north - 35.0) / 10.0, 2.0)));
    goals(north(WAY_M));

    assertThat(fly(90.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
    assertThat(logged("the ground leaves no way to the goal: climbing")).isOne();
  }

  @Test
  void waypoint_lowBehindARidge_climbsOverItAndDescends() throws IOException {
    start(4.0, (north, east) -> 40.0 * Math.exp(-Math.pow((north - 35.0) / 10.0, 2.0)));
    goals(north(WAY_M).z(4.0).verticalThreshold(1.0));

    assertThat(fly(120.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
  }

  @ParameterizedTest
  @CsvSource({"0.1", "0.2", "-0.1", "-0.2"})
  void waypoint_lowAboveASlope_isReached(double northward) throws IOException {
    start(4.0, (north, east) -> northward * north);
    goals(north(WAY_M).z(northward * WAY_M + 4.0).verticalThreshold(1.0));

    assertThat(fly(60.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(2.5);
  }

  /** It begins 5 to 25 m above the top, on the way down to a goal at its foot. */
  @ParameterizedTest
  @CsvSource({"5", "8", "12", "25"})
  void waypoint_belowAPlateauUnderTheVehicle_fliesOverItAndDescends(double aboveM)
      throws IOException {
    start(aboveM, (north, east) -> 40.0 / (1.0 + Math.exp((north - 45.0) / 3.0)));
    goals(north(WAY_M).z(4.0).verticalThreshold(1.0));

    assertThat(fly(90.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
  }

  /** The ridge is higher than the fence allows. */
  @Test
  void home_behindARidgeAboveTheCeiling_isGivenUp() throws IOException {
    start(4.0, (north, east) -> 40.0 * Math.exp(-Math.pow((north - 35.0) / 10.0, 2.0)));
    kit.publish(
        Channels.FENCE, new FenceState().keepIn(List.of()).keepOut(List.of()).highest(30.0));
    goals(north(WAY_M));

    assertThat(fly(90.0).reason().orElseThrow()).contains("ground that is too high counts as one");
    assertThat(vehicle.altitude).isLessThan(30.0);
  }

  /** A ridge across the way, in the middle between the vehicle and a goal beyond PLANNING SPAN. */
  private static DoubleBinaryOperator ridge(double halfLengthM) {
    return (north, east) ->
        30.0
            * Math.exp(-Math.pow((north - 0.5 * FAR_M) / 12.0, 2.0))
            / (1.0 + Math.exp((Math.abs(east) - halfLengthM) / 4.0));
  }

  /**
   * From each edge of the planned area, which may end before it, the way leads through the ridge.
   */
  @ParameterizedTest
  @CsvSource({"160", "60"})
  void home_beyondTheSpanBehindALongRidge_climbsOverIt(double span) throws IOException {
    spanM = span;
    start(4.0, ridge(1000.0));
    goals(north(FAR_M));

    assertThat(fly(90.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
    assertThat(logged("the ground leaves no way to the goal: climbing")).isOne();
  }

  @Test
  void waypoint_beyondTheSpanBehindALongRidge_climbsOverItAndDescends() throws IOException {
    start(4.0, ridge(1000.0));
    goals(north(FAR_M).z(4.0).verticalThreshold(1.0));

    assertThat(fly(120.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
  }

  /** It ends outside the planned area. */
  @Test
  void home_beyondTheSpanBehindAShortRidge_isReachedAroundIt() throws IOException {
    start(6.0, ridge(100.0));
    goals(north(FAR_M));

    assertThat(fly(90.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(4.0);
    assertThat(vehicle.altitude).isLessThan(7.0);
  }

  /** A way around is then no longer too long. */
  @Test
  void home_beyondTheSpanBehindARidgeAboveTheCeiling_isReachedAroundIt() throws IOException {
    start(6.0, ridge(160.0));
    kit.publish(
        Channels.FENCE, new FenceState().keepIn(List.of()).keepOut(List.of()).highest(25.0));
    goals(north(FAR_M));

    assertThat(fly(150.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(4.0);
    assertThat(vehicle.altitude).isLessThan(25.0);
  }

  @Test
  void home_beyondTheSpanBehindALongRidgeAboveTheCeiling_isGivenUp() throws IOException {
    start(4.0, ridge(1000.0));
    kit.publish(
        Channels.FENCE, new FenceState().keepIn(List.of()).keepOut(List.of()).highest(25.0));
    goals(north(FAR_M));

    assertThat(fly(60.0).reason().orElseThrow()).contains("ground that is too high counts as one");
    assertThat(vehicle.altitude).isLessThan(25.0);
  }
}
