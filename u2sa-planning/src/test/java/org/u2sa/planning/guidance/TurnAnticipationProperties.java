package org.u2sa.planning.guidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class TurnAnticipationProperties {
  private static final double THRESHOLD_M = 100.0;
  private static final double ACCELERATION = 4.57;
  private final TurnAnticipation turns = new TurnAnticipation(ACCELERATION, 0.0, 60.0);

  /**
   * How near an arc that begins so far before the waypoint passes it, beside the leg by {@code
   * inside}.
   */
  private double passingM(double distance, double inside, double radius, double turn) {
    double swept = Math.atan2(distance, radius - inside);
    if (swept <= Math.abs(turn)) {
      return Math.abs(Math.hypot(distance, radius - inside) - radius);
    }
    double along = radius * Math.sin(turn) - distance; // the arc ends before it comes nearest
    double aside = radius * (1.0 - Math.cos(turn)) + inside;
    return Math.abs(along * Math.sin(turn) - aside * Math.cos(turn));
  }

  @Property
  void distanceM_onTheLeg_theArcPassesWithinTheCorner(
      @ForAll @DoubleRange(min = 5.0, max = 80.0) double speed,
      @ForAll @DoubleRange(min = 0.05, max = 3.1) double turn,
      @ForAll @DoubleRange(min = 1.0, max = 500.0) double threshold) {
    double distance = turns.distanceM(speed, turn, 0.0, threshold);

    assertThat(passingM(distance, 0.0, turns.radiusM(speed), turn))
        .isLessThanOrEqualTo(Math.min(0.6 * threshold, 60.0) + 1.0e-6);
  }

  @Property
  void distanceM_gentleTurn_theArcEndsOnTheNextLeg(
      @ForAll @DoubleRange(min = 20.0, max = 80.0) double speed,
      @ForAll @DoubleRange(min = 0.05, max = 0.3) double turn) {
    double radius = turns.radiusM(speed);

    assertThat(turns.distanceM(speed, turn, 0.0, THRESHOLD_M))
        .isCloseTo(radius * Math.tan(turn / 2.0), within(1.0e-6));
  }

  @Property
  void distanceM_offTheLegToTheInside_beginsNoSooner(
      @ForAll @DoubleRange(min = 5.0, max = 80.0) double speed,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double turn,
      @ForAll @DoubleRange(min = -100.0, max = 100.0) double inside) {
    assertThat(turns.distanceM(speed, turn, inside + 5.0, THRESHOLD_M))
        .isLessThanOrEqualTo(turns.distanceM(speed, turn, inside, THRESHOLD_M));
  }

  @Property
  void distanceM_turnsOnTheSpot_anticipatesNothing(
      @ForAll @DoubleRange(min = 0.0, max = 80.0) double speed,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double turn) {
    assertThat(new TurnAnticipation(0.0, 1.0, 60.0).distanceM(speed, turn, 0.0, THRESHOLD_M))
        .isZero();
  }

  @Example
  void distanceM_lag_isFlownBeforeTheArc() {
    double without = turns.distanceM(46.0, 1.5, 0.0, THRESHOLD_M);

    assertThat(new TurnAnticipation(ACCELERATION, 2.0, 60.0).distanceM(46.0, 1.5, 0.0, THRESHOLD_M))
        .isCloseTo(without + 92.0, within(1.0e-9));
  }
}
