package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class RoundedTerrainTest {
  private static final int SIDE = 21;

  private interface Profile {
    double at(double eastM, double northM);
  }

  /** Heights every 2 m. */
  private static HeightMap map(Profile profile) {
    double[] heights = new double[SIDE * SIDE];
    for (int i = 0; i < heights.length; i++) {
      heights[i] = profile.at(2.0 * (i % SIDE) - 20.0, 20.0 - 2.0 * (i / SIDE));
    }
    return HeightMap.of(heights, SIDE, 40.0, 40.0);
  }

  @Test
  void rise_acrossTheEdgesOfCells_changesOverTheWheelbase() {
    Terrain met = map((e, n) -> 0.25 * Math.sin(0.8 * n) * Math.cos(0.6 * e)).underWheels();
    double most = 0.0;
    for (double at = -15.0; at < 15.0; at += 0.002) {
      double north = met.riseNorth(0.3 * at, at + 0.002) - met.riseNorth(0.3 * at, at);
      double east = met.riseEast(0.3 * at + 0.002, at) - met.riseEast(0.3 * at, at);
      most = Math.max(most, Math.max(Math.abs(north), Math.abs(east)));
    }
    assertThat(most).isLessThan(0.003); // on the bare map, up to 0.27 at once
  }

  @Test
  void rise_onAUniformSlope_isThatSlope() {
    Terrain met = map((e, n) -> 0.1 * e - 0.2 * n).underWheels();

    assertThat(met.riseEast(3.1, -4.7)).isCloseTo(0.1, within(1e-9));
    assertThat(met.riseNorth(3.1, -4.7)).isCloseTo(-0.2, within(1e-9));
    assertThat(met.heightM(3.1, -4.7)).isCloseTo(0.31 + 0.94, within(1e-9));
  }
}
