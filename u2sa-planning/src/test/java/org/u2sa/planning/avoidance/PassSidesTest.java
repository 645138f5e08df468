package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.data.Offset.offset;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.seen.PlanarShape;

/** On which side of a mark the way is closed, and for how long. */
class PassSidesTest {
  private static final double REACH_M = 2.5;
  private static final double CIRCLE_M = 0.6;

  private final PassSides sides = new PassSides();

  private boolean see(PassSides.Side side, Pose vehicle, Optional<RouteTrack> route) {
    Map<PassSides.Side, List<PlanarShape>> seen =
        Map.of(side, List.of(PlanarShape.disc("flag 1", 4.0, 0.0, 0.03)));
    return sides.see(seen, vehicle, route, REACH_M, CIRCLE_M);
  }

  private static Pose northward(double northM) {
    return new Pose(northM, 0.2, 0.0);
  }

  private double closedM(double northM, double eastM) {
    return sides.shapes().get(0).distanceM(northM, eastM);
  }

  @Test
  void see_markToPassOnItsLeft_rightOfItIsClosed() {
    assertThat(see(PassSides.Side.LEFT, northward(0.0), Optional.empty())).isTrue();
    assertThat(closedM(4.0, 2.5)).isZero();
    assertThat(closedM(4.0, -1.0)).isEqualTo(1.0);
  }

  @Test
  void see_markToPassOnItsRight_leftOfItIsClosed() {
    see(PassSides.Side.RIGHT, northward(0.0), Optional.empty());
    assertThat(closedM(4.0, -2.5)).isZero();
    assertThat(closedM(4.0, 1.0)).isEqualTo(1.0);
  }

  @Test
  void see_routeThatTurnsEastAtTheMark_sideIsThatOfTheRoute() {
    Route route =
        Route.of(
            List.of(
                new Route.Point(0.0, 0.0, false),
                new Route.Point(3.0, 0.0, false),
                new Route.Point(4.5, 4.0, false)),
            8.0);
    see(PassSides.Side.LEFT, northward(0.0), Optional.of(new RouteTrack(route)));
    double course = Math.atan2(4.0, 1.5);
    double north = 4.0 - REACH_M * Math.sin(course);
    assertThat(closedM(north, REACH_M * Math.cos(course))).isCloseTo(0.0, offset(1e-9));
  }

  @Test
  void see_fromAfar_nothingIsClosedYet() {
    assertThat(see(PassSides.Side.LEFT, northward(-1.0), Optional.empty())).isFalse();
    assertThat(sides.shapes()).isEmpty();
  }

  @Test
  void see_markPassed_wayIsOpenAndStaysSo() {
    see(PassSides.Side.LEFT, northward(0.0), Optional.empty());
    assertThat(see(PassSides.Side.LEFT, northward(4.5), Optional.empty())).isFalse();
    assertThat(see(PassSides.Side.LEFT, northward(4.7), Optional.empty())).isTrue();
    assertThat(sides.shapes()).isEmpty();
    assertThat(see(PassSides.Side.LEFT, northward(3.0), Optional.empty())).isFalse();
    assertThat(sides.shapes()).isEmpty();
  }

  @Test
  void parse_listOfTypes_hasTheirSides() {
    assertThat(PassSides.parse(" red flag: left, blue flag :RIGHT, "))
        .containsExactly(
            Map.entry("red flag", PassSides.Side.LEFT),
            Map.entry("blue flag", PassSides.Side.RIGHT));
  }

  @Test
  void parse_noSide_isRefusedNamingTheEntry() {
    assertThatThrownBy(() -> PassSides.parse("red flag: LEFT, buoy: PORT"))
        .hasMessage(
            "PASS SIDES: \"buoy: PORT\": expected a type and the side to pass on, such as red flag: LEFT");
    assertThatThrownBy(() -> PassSides.parse("LEFT")).hasMessageContaining("\"LEFT\"");
  }
}
