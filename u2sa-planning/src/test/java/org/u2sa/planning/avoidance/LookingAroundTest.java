package org.u2sa.planning.avoidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.planning.local.ArcChoice;

/** A rover that points north, and does not turn. */
class LookingAroundTest {
  private final AvoidanceBench bench = new AvoidanceBench();
  private final LookingAround looking = new LookingAround();

  private double bearingDeg(double seconds, double headingDeg) {
    Situation now = bench.at(seconds, 0.0, 0.0, Math.toRadians(headingDeg));
    ArcChoice choice = looking.choose(bench.arcs(now), now);
    assertThat(choice.speedMps()).isPositive();
    return Math.toDegrees(Math.atan2(choice.eastM(), choice.northM()));
  }

  @Test
  void choose_first_turnsSixtyDegreesToTheRight() {
    assertThat(bearingDeg(100.0, 0.0)).isCloseTo(60.0, within(1.0e-9));
  }

  @Test
  void choose_sameStep_keepsTheDirectionThenTurnsOn() {
    bearingDeg(100.0, 0.0);

    assertThat(bearingDeg(102.5, 30.0)).isCloseTo(60.0, within(1.0e-9));
    assertThat(bearingDeg(102.6, 60.0)).isCloseTo(120.0, within(1.0e-9));
  }
}
