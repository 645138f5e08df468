package org.u2sa.planning.rightofway;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RuleTest {
  private static final double HALF_DEGREE = Math.toRadians(0.5);

  @ParameterizedTest
  @CsvSource({
    "0, 0, HEAD_ON",
    "-5, 5, HEAD_ON",
    "5, -5, HEAD_ON",
    "6, -6, CROSSING_GIVE_WAY",
    "112, -60, CROSSING_GIVE_WAY",
    "-6, 6, CROSSING_STAND_ON",
    "-60, 112, CROSSING_STAND_ON",
    "0, 180, OVERTAKING",
    "67, -113, OVERTAKING",
    "-67, 113, OVERTAKING",
    "180, 0, OVERTAKEN",
    "113, -67, OVERTAKEN",
    "-113, 67, OVERTAKEN",
    "10, 10, HEAD_ON",
    "-10, -10, HEAD_ON"
  })
  void of_bearingAndAspect_isTheRuleOfTheirSectors(double bearing, double aspect, Rule expected) {
    assertThat(Rule.of(Math.toRadians(bearing), Math.toRadians(aspect), 0.0)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "6, -6, CROSSING_GIVE_WAY, HEAD_ON",
    "-6, 6, CROSSING_STAND_ON, HEAD_ON",
    "60, -111, CROSSING_GIVE_WAY, OVERTAKING"
  })
  void of_doubt_isHeadOnOrOvertaking(double bearing, double aspect, Rule sure, Rule inDoubt) {
    double beta = Math.toRadians(bearing);
    double alpha = Math.toRadians(aspect);

    assertThat(Rule.of(beta, alpha, 0.0)).isEqualTo(sure);
    assertThat(Rule.of(beta, alpha, Math.toRadians(2.0))).isEqualTo(inDoubt);
  }

  /** What one vessel sees is the counterpart of what the other one sees. */
  @Test
  void of_vesselsThatMeet_agreeWhoGivesWay() {
    Random random = new Random(7);
    for (int i = 0; i < 20_000; i++) {
      double course = 2.0 * Math.PI * random.nextDouble();
      double ownMps = 0.5 + 2.0 * random.nextDouble();
      double otherMps = 0.5 + 2.0 * random.nextDouble();
      // both reach the origin at the same time
      double north = ownMps - otherMps * Math.cos(course);
      double east = -otherMps * Math.sin(course);
      double bearing = Math.atan2(east, north);
      double aspect = bearing + Math.PI - course;
      if (isNearLimit(bearing) || isNearLimit(aspect)) {
        continue;
      }
      Rule own = Rule.of(bearing, aspect, 0.0);
      Rule other = Rule.of(aspect, bearing, 0.0);

      assertThat(other).as("course %f, %s", Math.toDegrees(course), own).isEqualTo(counter(own));
    }
  }

  private static boolean isNearLimit(double angle) {
    double size = Math.abs(Angles.wrapped(angle));
    return Math.abs(size - Math.toRadians(5.0)) < HALF_DEGREE
        || Math.abs(size - Math.toRadians(67.5)) < HALF_DEGREE
        || Math.abs(size - Math.toRadians(112.5)) < HALF_DEGREE
        || size < HALF_DEGREE;
  }

  private static Rule counter(Rule rule) {
    return switch (rule) {
      case HEAD_ON -> Rule.HEAD_ON;
      case OVERTAKING -> Rule.OVERTAKEN;
      case OVERTAKEN -> Rule.OVERTAKING;
      case CROSSING_GIVE_WAY -> Rule.CROSSING_STAND_ON;
      case CROSSING_STAND_ON -> Rule.CROSSING_GIVE_WAY;
    };
  }

  /** A mirrored meeting swaps the parts of crossing vessels, and changes nothing else. */
  @Test
  void of_mirroredMeeting_swapsThePartsOfCrossingVessels() {
    for (int deg = 0; deg < 360; deg++) {
      for (double mps : new double[] {0.6, 1.4, 2.5}) {
        double course = Math.toRadians(deg);
        double bearing = Math.atan2(-mps * Math.sin(course), 1.5 - mps * Math.cos(course));
        double aspect = bearing + Math.PI - course;
        if (isNearLimit(bearing) || isNearLimit(aspect)) {
          continue;
        }
        Rule rule = Rule.of(bearing, aspect, 0.0);
        boolean crosses = rule == Rule.CROSSING_GIVE_WAY || rule == Rule.CROSSING_STAND_ON;

        assertThat(Rule.of(-bearing, -aspect, 0.0))
            .as("course %d at %.1f m/s", deg, mps)
            .isEqualTo(crosses ? counter(rule) : rule);
      }
    }
  }
}
