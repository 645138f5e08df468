package org.u2sa.service.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class DriftFilterTest {
  private static final double EASTWARD_MPS = 0.4;
  private static final double SLIP_M = -0.5; // to the left in a turn to the right

  private final DriftFilter filter = new DriftFilter();
  private double headingRad;

  /** Sails in a steady eastward drift; the hull slips in turns. */
  private void sail(double turnRadps, double seconds) {
    for (double t = 0.0; t < seconds; t += 0.05) {
      headingRad += 0.05 * turnRadps;
      double aside = EASTWARD_MPS * Math.cos(headingRad) + SLIP_M * turnRadps;
      filter.step(headingRad, aside, turnRadps, 0.05);
    }
  }

  @Test
  void crabRad_driftFromTheLeft_turnsTheBowToTheLeft() {
    sail(0.0, 30.0);

    assertThat(filter.drift().crabRad(0.0, 1.0)).isCloseTo(-Math.asin(EASTWARD_MPS), within(0.03));
  }

  @Test
  void crabRad_afterTurningBack_isOnTheOtherSideAtOnce() {
    sail(0.0, 30.0);
    sail(Math.PI / 8.0, 8.0); // half a turn

    assertThat(filter.drift().crabRad(Math.PI, 1.0))
        .isCloseTo(Math.asin(EASTWARD_MPS), within(0.1));
  }

  @Test
  void crabRad_alongTheDrift_isNone() {
    sail(0.2, 120.0);

    assertThat(filter.drift().crabRad(Math.PI / 2.0, 1.0)).isCloseTo(0.0, within(0.05));
  }

  @Test
  void crabRad_driftFasterThanTheVehicle_staysWithinItsLimit() {
    sail(0.0, 30.0);

    assertThat(Math.toDegrees(filter.drift().crabRad(0.0, 0.1))).isCloseTo(-50.0, within(0.1));
  }
}
