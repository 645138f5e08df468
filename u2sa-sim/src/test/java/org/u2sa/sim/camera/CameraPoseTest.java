package org.u2sa.sim.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

class CameraPoseTest {
  private static CameraPose at(double thetaRad, Point rates, double laterS) {
    ColourLens lens =
        new ColourLens(10.0, 160, 120, 1.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    CameraPose pose = new CameraPose(lens);
    pose.at(
        new VehicleTruth(
            0.0, Point.ORIGIN, new Attitude(0.0, thetaRad, 0.0), Point.ORIGIN, rates, Point.ORIGIN),
        laterS);
    return pose;
  }

  @Test
  void at_straightDownWhileTurning_turnsAboutItsOwnAxis() {
    CameraPose pose = at(Math.toRadians(-90.0), Point.of(0.5, 0.0, 0.0), 0.1);

    assertThat(pose.axis[2]).isCloseTo(-1.0f, within(1e-5f));
    assertThat(pose.right[0]).isCloseTo((float) Math.cos(0.05), within(1e-5f)); // east
    assertThat(Math.abs(pose.right[1])).isCloseTo((float) Math.sin(0.05), within(1e-5f));
  }

  @Test
  void at_onEitherSideOfTheSteepLimit_isTheSame() {
    Point rates = Point.of(0.2, -0.1, 0.3);
    CameraPose below = at(1.4999, rates, 0.01);
    CameraPose beyond = at(1.5001, rates, 0.01);

    for (int i = 0; i < 3; i++) {
      assertThat(beyond.right[i]).isCloseTo(below.right[i], within(1e-3f));
      assertThat(beyond.axis[i]).isCloseTo(below.axis[i], within(1e-3f));
    }
  }
}
