package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.util.AffineTransformation;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FailsafeAction;

/** Distances worked out by hand, and what a region covers. */
class ManoeuvreTest {
  private static final Offset<Double> NEAR = within(1.0e-6);
  private static final double BANK_OF_ONE_G = Math.PI / 4.0; // turns with g sideways

  private static boolean covers(Geometry region, double east, double north) {
    return region.covers(new GeometryFactory().createPoint(new Coordinate(east, north)));
  }

  private static Manoeuvre turn(double leastRadiusM, double windMps) {
    return new Manoeuvre(true, 1.0, 1.0, BANK_OF_ONE_G, leastRadiusM, windMps, 0.5, 5.0);
  }

  private static SafetyVariables settings(Map<String, ?> values) {
    return XmlConfiguration.inMemory("test", values).settings(SafetyVariables.class).get();
  }

  @Test
  void of_configuration_takesEachVariable() {
    Map<String, Object> values =
        Map.of(
            "FENCE MANOEUVRE", "TURN",
            "REACTION TIME", 2.0,
            "BRAKING", 3.0,
            "TURN BANK", 0.5,
            "HOLD RADIUS", 70.0,
            "WIND ALLOWANCE", 4.0,
            "VERTICAL ACCELERATION", 0.6,
            "DRIFT TIME", 7.0);

    assertThat(Manoeuvre.of(settings(values), FailsafeAction.HOLD))
        .isEqualTo(new Manoeuvre(true, 2.0, 3.0, 0.5, 70.0, 4.0, 0.6, 7.0));
    assertThat(Manoeuvre.of(settings(Map.of("HOLD RADIUS", 70.0)), FailsafeAction.RETURN))
        .as("returns instead of circling")
        .isEqualTo(new Manoeuvre(false, 1.0, 1.0, 0.4, 0.0, 0.0, 0.8, 5.0));
  }

  @Test
  void stopping_tenMetresPerSecond_isHalfItsSquareByTheDeceleration() {
    assertThat(new Manoeuvre(false, 0.0, 2.0, 0.4, 0.0, 0.0, 1.0, 5.0).stoppingM(10.0))
        .isCloseTo(25.0, NEAR);
  }

  @Test
  void turnRadius_withWindAndHoldingCircle_isTheWidest() {
    assertThat(turn(0.0, 0.0).turnRadiusM(9.80665)).isCloseTo(9.80665, NEAR);
    assertThat(turn(0.0, 9.80665).turnRadiusM(9.80665)).isCloseTo(4.0 * 9.80665, NEAR);
    assertThat(turn(50.0, 0.0).turnRadiusM(9.80665)).isCloseTo(50.0, NEAR);
  }

  /** Half a turn of radius 4·9.80665 m at 2·9.80665 m/s takes 2π s. */
  @Test
  void drift_whileItTurnsRound_isTheWindsWay() {
    assertThat(turn(0.0, 9.80665).driftM(9.80665)).isCloseTo(9.80665 * 2.0 * Math.PI, NEAR);
    assertThat(turn(0.0, 0.0).driftM(9.80665)).isZero();
  }

  /** One second straight on, then v²/2a. */
  @Test
  void overshoot_upAndDown_isSigned() {
    assertThat(turn(0.0, 0.0).overshootM(3.0)).isCloseTo(3.0 + 9.0, NEAR);
    assertThat(turn(0.0, 0.0).overshootM(-3.0)).isCloseTo(-3.0 - 9.0, NEAR);
    assertThat(turn(0.0, 0.0).overshootM(0.0)).isZero();
  }

  @Test
  void region_standing_isThePlace() {
    Geometry region = turn(0.0, 5.0).region(Point.of(3.0, 4.0, 0.0), Point.of(0.05, 0.05, 0.0));
    assertThat(region.getArea()).isZero();
    assertThat(region.getLength()).isZero();
    assertThat(covers(region, 3.0, 4.0)).isTrue();
  }

  /** 5 m/s to the east-north-east (4, 3): 5 m of reaction and 12.5 m of braking. */
  @Test
  void region_brakes_isTheLineToWhereItStands() {
    Manoeuvre brake = new Manoeuvre(false, 1.0, 1.0, 0.4, 0.0, 0.0, 1.0, 5.0);
    Geometry region = brake.region(Point.of(100.0, 200.0, 0.0), Point.of(4.0, 3.0, 0.0));

    assertThat(region.getLength()).isCloseTo(17.5, NEAR);
    Coordinate end = region.getCoordinates()[1];
    assertThat(end.x).isCloseTo(114.0, NEAR);
    assertThat(end.y).isCloseTo(210.5, NEAR);
    assertThat(region.getCoordinates()[0]).isEqualTo(new Coordinate(100.0, 200.0));
  }

  /** Northward, radius and speed 9.80665, reaction 1 s: both half circles begin 9.81 m ahead. */
  @Test
  void region_turns_coversBothHalfCirclesAndLittleMore() {
    double r = 9.80665;
    Geometry region = turn(0.0, 0.0).region(Point.of(50.0, 60.0, 0.0), Point.of(0.0, r, 0.0));

    for (double side : new double[] {-1.0, 1.0}) {
      for (double angle = 0.0; angle <= Math.PI; angle += 0.1) {
        double east = 50.0 + side * (r - r * Math.cos(angle));
        assertThat(covers(region, east, 60.0 + r + r * Math.sin(angle))).as("%s", angle).isTrue();
      }
      assertThat(covers(region, 50.0 + side * 2.05 * r, 60.0 + r)).as("aside").isFalse();
    }
    assertThat(covers(region, 50.0, 60.0)).isTrue();
    assertThat(covers(region, 50.0, 60.0 + 2.05 * r)).as("ahead").isFalse();
    assertThat(covers(region, 50.0, 59.9)).as("behind").isFalse();
  }

  /** Half a g sideways, by a bank whose tangent is 0.5. */
  @Test
  void turnRadius_ofAFlatterBank_isWider() {
    Manoeuvre flat = new Manoeuvre(true, 1.0, 1.0, Math.atan(0.5), 0.0, 0.0, 1.0, 5.0);

    assertThat(flat.turnRadiusM(9.80665)).isCloseTo(2.0 * 9.80665, NEAR);
  }

  /** Three seconds straight on, then v²/2a with 2 m/s². */
  @Test
  void overshoot_slowToReact_isTheWayOfBothParts() {
    Manoeuvre slow = new Manoeuvre(true, 3.0, 1.0, 0.4, 0.0, 0.0, 2.0, 5.0);

    assertThat(slow.overshootM(4.0)).isCloseTo(12.0 + 4.0, NEAR);
    assertThat(slow.overshootM(-4.0)).isCloseTo(-12.0 - 4.0, NEAR);
  }

  @Test
  void region_atTheSlowestSpeedThatCounts_isALine() {
    Manoeuvre brake = new Manoeuvre(false, 2.0, 1.0, 0.4, 0.0, 0.0, 1.0, 5.0);

    assertThat(brake.region(Point.of(0.0, 0.0, 0.0), Point.of(0.1, 0.0, 0.0)).getLength())
        .isCloseTo(0.2 + 0.005, NEAR);
    assertThat(brake.region(Point.of(0.0, 0.0, 0.0), Point.of(0.099, 0.0, 0.0)).getLength())
        .isZero();
  }

  /** Eastward, to the north and on any course between: the same form, turned. */
  @Test
  void region_turnsOnAnyCourse_isTheSameFormTurned() {
    Manoeuvre windy = new Manoeuvre(true, 2.0, 1.0, 0.4, 0.0, 2.0, 1.0, 5.0);
    Geometry east = windy.region(Point.of(50.0, 60.0, 0.0), Point.of(10.0, 0.0, 0.0));

    for (double course : new double[] {0.3, 1.0, Math.PI / 2.0, 2.5, 4.0, 6.0}) {
      Geometry turned =
          windy.region(
              Point.of(50.0, 60.0, 0.0),
              Point.of(10.0 * Math.cos(course), 10.0 * Math.sin(course), 0.0));
      Geometry expected = AffineTransformation.rotationInstance(course, 50.0, 60.0).transform(east);
      assertThat(turned.symDifference(expected).getArea()).as("%s rad", course).isLessThan(1e-3);
    }
  }

  /** The wind may blow it on in any direction, sideways and back as well. */
  @Test
  void region_turnsInWind_isWiderByTheDriftOnAllSides() {
    Manoeuvre windy = turn(0.0, 2.0);
    double speed = 10.0;
    double radius = windy.turnRadiusM(speed);
    double drift = windy.driftM(speed);
    Geometry region = windy.region(Point.of(0.0, 0.0, 0.0), Point.of(speed, 0.0, 0.0));

    double aside = 2.0 * radius + drift;
    assertThat(covers(region, speed + radius + drift, 0.0)).isTrue();
    assertThat(covers(region, speed + 1.05 * (radius + drift), 0.0)).isFalse();
    assertThat(covers(region, speed - drift + 0.01, aside)).isTrue();
    assertThat(covers(region, speed - drift + 0.01, -aside)).isTrue();
    assertThat(covers(region, speed - drift - 1.0, aside)).isFalse();
    assertThat(covers(region, speed, 1.05 * aside)).isFalse();
    assertThat(covers(region, speed, -1.05 * aside)).isFalse();
  }

  /**
   * At 4 m/s: 4 m of reaction, 8 m of braking in 4 s, and 0.5 m/s of drift in these and 6 s more.
   */
  @Test
  void region_brakesWithWindAllowance_reachesOnByTheDriftAheadAndAside() {
    Manoeuvre brake = new Manoeuvre(false, 1.0, 1.0, 0.4, 0.0, 0.5, 1.0, 6.0);
    Geometry region = brake.region(Point.of(0.0, 0.0, 0.0), Point.of(0.0, 4.0, 0.0));

    assertThat(brake.driftM(4.0)).isCloseTo(5.0, NEAR);
    assertThat(brake.wayToStopM(4.0)).isCloseTo(17.0, NEAR);
    assertThat(covers(region, 0.0, 17.0)).isTrue();
    assertThat(covers(region, 0.0, 17.1)).isFalse();
    assertThat(covers(region, 5.0, 12.0)).isTrue();
    assertThat(covers(region, -5.0, 12.0)).isTrue();
    assertThat(covers(region, 5.1, 12.0)).isFalse();
    assertThat(covers(region, 0.0, -0.01)).as("behind").isFalse();
  }

  /** What holds against a drift of 0.5 m/s moves no faster than 0.2 m/s, whatever carries it. */
  @Test
  void drift_movesMoreSlowlyThanTheAllowance_isThatOfItsSpeed() {
    assertThat(new Manoeuvre(false, 1.0, 1.0, 0.4, 0.0, 0.5, 1.0, 6.0).driftM(0.2))
        .isCloseTo(0.2 * 6.2, NEAR);
  }

  @Test
  void driftingAt_fasterThanTheAllowance_countsOnlyForWhatBrakesAndHasAnAllowance() {
    Manoeuvre brake = new Manoeuvre(false, 1.0, 1.0, 0.4, 0.0, 0.5, 1.0, 6.0);
    Manoeuvre holds = new Manoeuvre(false, 1.0, 1.0, 0.4, 0.0, 0.0, 1.0, 6.0);

    assertThat(brake.driftingAt(0.8))
        .isEqualTo(new Manoeuvre(false, 1.0, 1.0, 0.4, 0.0, 0.8, 1.0, 6.0));
    assertThat(brake.driftingAt(0.3)).isEqualTo(brake);
    assertThat(holds.driftingAt(9.0)).isEqualTo(holds);
    assertThat(turn(0.0, 2.0).driftingAt(9.0)).isEqualTo(turn(0.0, 2.0));
  }
}
