package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.u2sa.planning.curve.Pose;

class MotionLimitsProperties {
  private static final double RADIUS_M = 2.0;
  private static final MotionLimits LIMITS =
      new MotionLimits(1.0, 0.8, 1.0, RADIUS_M, true, 1.0, 1.0, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.0);

  @Property
  void curvatureTo_pointThatAnArcReaches_theArcEndsThere(
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double curvature,
      @ForAll @DoubleRange(min = 0.5, max = 3.0) double wayM,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double headingRad) {
    Pose from = new Pose(3.0, -4.0, headingRad);
    Pose there = from.along(wayM, curvature);

    assertThat(LIMITS.curvatureTo(from, there.northM(), there.eastM(), false))
        .isCloseTo(curvature, within(1.0e-9));
  }

  @Example
  void curvatureTo_pointBehind_isTheTightestToItsSide() {
    Pose north = new Pose(0.0, 0.0, 0.0);

    assertThat(LIMITS.curvatureTo(north, -5.0, 1.0, false)).isEqualTo(1.0 / RADIUS_M);
    assertThat(LIMITS.curvatureTo(north, -5.0, -1.0, false)).isEqualTo(-1.0 / RADIUS_M);
    assertThat(LIMITS.curvatureTo(north, -5.0, 1.0, true)).isCloseTo(2.0 / 26.0, within(1.0e-9));
  }

  @Example
  void curvatureTo_pointInsideTheTurningCircle_isTheTightest() {
    assertThat(LIMITS.curvatureTo(new Pose(0.0, 0.0, 0.0), 0.5, 1.0, false))
        .isEqualTo(1.0 / RADIUS_M);
  }
}
