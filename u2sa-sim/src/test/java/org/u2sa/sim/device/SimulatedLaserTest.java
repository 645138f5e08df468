package org.u2sa.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.RangeScan;
import org.u2sa.sim.sensor.NoiseStreams;

/** A pole 2 m away before a wall 5 m away; the beams to the left see nothing. */
class SimulatedLaserTest {
  private static final SimulatedLaser.Optics OPTICS =
      new SimulatedLaser.Optics(10.0, -1.0, 0.01, 201, 0.06, 10.0, 0.0);
  private static final SimulatedLaser.Sight SCENE =
      (angle, cos, sin) ->
          angle > 0.5 ? Double.POSITIVE_INFINITY : Math.abs(angle) < 0.1 ? 2.0 : 5.0;

  private static RangeScan scan(SimulatedLaser.Faults faults, long seed) {
    NoiseStreams streams = new NoiseStreams(seed);
    return new SimulatedLaser(OPTICS, faults, streams, () -> SCENE)
        .measure(1.0, 1_000_000L)
        .beams();
  }

  private static long between(RangeScan scan) {
    long count = 0;
    for (int i = 0; i < scan.ranges().size(); i++) {
      double range = scan.ranges().get(i);
      count += scan.returns().get(i) && range > 2.0 && range < 5.0 ? 1 : 0;
    }
    return count;
  }

  @Test
  void measure_withoutFaults_everyBeamIsOfThePoleOrTheWall() {
    RangeScan scan = scan(SimulatedLaser.Faults.NONE, 1L);

    assertThat(between(scan)).isZero();
    assertThat(scan.returns().stream().filter(echo -> echo).count()).isBetween(150L, 152L);
  }

  @Test
  void measure_allBeamsAtEdgesMixed_oneAtEachEdgeMeasuresSomethingBetween() {
    SimulatedLaser.Faults mixed = new SimulatedLaser.Faults(0.0, 1.0);
    for (long seed = 1; seed <= 20; seed++) {
      assertThat(between(scan(mixed, seed))).isEqualTo(2); // none where there is nothing behind
    }
  }

  @Test
  void measure_aTenthOfTheEchoesLost_aTenthIsMissing() {
    SimulatedLaser.Faults lost = new SimulatedLaser.Faults(0.1, 0.0);
    double echoes = 0.0;
    for (long seed = 1; seed <= 100; seed++) {
      echoes += scan(lost, seed).returns().stream().filter(echo -> echo).count();
    }
    assertThat(echoes / (100.0 * 151.0)).isCloseTo(0.9, within(0.02));
  }

  @Test
  void faults_shareAboveOne_isRefusedByName() {
    assertThatThrownBy(() -> new SimulatedLaser.Faults(0.0, 1.5))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("mixed pixels")
        .hasMessageContaining("1.5");
  }
}
