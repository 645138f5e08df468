package org.u2sa.vision.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.vision.ground.GroundSigma.SlopeSigma;

class SlopeSigmaTest {
  private static final double ABOVE = 0.035;

  @Test
  void rad_swayOfAVehicleOnLevelGround_isNone() {
    assertThat(SlopeSigma.rad(ABOVE, 0.02, -0.02)).isZero();
  }

  @Test
  void rad_onARamp_isThatOfAnythingFromLevelToItsSlope() {
    assertThat(SlopeSigma.rad(ABOVE, 0.0, -0.15)).isCloseTo(0.15 / Math.sqrt(3.0), within(1.0e-12));
  }

  @Test
  void alongM_onARamp_growsWithTheSquareOfTheDistance() {
    GroundSigma level = new GroundSigma(0.002, 0.008, 0.008, 0.02, 0.0);
    GroundSigma ramp = level.uneven(SlopeSigma.rad(ABOVE, 0.0, 0.15), 0.0);
    assertThat(ramp.alongM(3.0, 1.1)).isGreaterThan(8.0 * level.alongM(3.0, 1.1));
    assertThat(ramp.acrossM(3.0)).isEqualTo(level.acrossM(3.0));
  }

  @Test
  void alongM_groundOfUncertainHeight_growsWithTheDistance() {
    GroundSigma sigma = new GroundSigma(0.0, 0.0, 0.0, 0.0, 0.0).uneven(0.0, 0.1);
    assertThat(sigma.alongM(3.0, 1.2)).isCloseTo(3.0 * 0.1 / 1.2, within(1e-12));
    assertThat(sigma.acrossM(3.0)).isZero();
  }
}
