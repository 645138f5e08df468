package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Point;

/** Signs of the mounting pose in BODY: x forward, y left, z down. */
class MountingPoseTest {
  private static final double QUARTER = Math.PI / 2.0;
  private static final Point AHEAD = Point.of(2.0, 0.0, 0.0);
  private static final Point LEFT = Point.of(0.0, 2.0, 0.0);

  private static void assertSeen(double roll, double pitch, double yaw, Point seen, Point body) {
    MountingPose pose = new MountingPose(0.3, 0.1, -0.2, roll, pitch, yaw);
    assertThat(pose.turn().toBody(seen).distanceTo(body.plus(Point.of(0.3, 0.1, -0.2))))
        .isLessThan(1.0e-9);
  }

  @Test
  void toBody_notTurned_isMovedOnly() {
    assertSeen(0.0, 0.0, 0.0, Point.of(1.0, 2.0, 3.0), Point.of(1.0, 2.0, 3.0));
  }

  @Test
  void toBody_turnedLeft_aheadIsLeft() {
    assertSeen(0.0, 0.0, QUARTER, AHEAD, Point.of(0.0, 2.0, 0.0));
    assertSeen(0.0, 0.0, QUARTER, LEFT, Point.of(-2.0, 0.0, 0.0));
  }

  @Test
  void toBody_frontUp_aheadIsAbove() {
    assertSeen(0.0, QUARTER, 0.0, AHEAD, Point.of(0.0, 0.0, -2.0));
    assertSeen(0.0, QUARTER, 0.0, LEFT, LEFT);
  }

  @Test
  void toBody_leftSideDown_leftIsBelow() {
    assertSeen(QUARTER, 0.0, 0.0, LEFT, Point.of(0.0, 0.0, 2.0));
    assertSeen(QUARTER, 0.0, 0.0, AHEAD, AHEAD);
  }

  @Test
  void toBody_turnedLeftThenTilted_tiltsAboutItsOwnAxis() {
    // looks left and 30 degrees down
    assertSeen(
        0.0, -Math.PI / 6.0, QUARTER, AHEAD, Point.of(0.0, 2.0 * Math.cos(Math.PI / 6.0), 1.0));
  }

  @Test
  void read_variables_areThePose() {
    MountingPose pose =
        XmlConfiguration.inMemory("the test", Map.of("MOUNTED Z", -0.5, "MOUNTED YAW", 1.0))
            .settings(MountingPose.class)
            .get();
    assertThat(pose).isEqualTo(new MountingPose(0.0, 0.0, -0.5, 0.0, 0.0, 1.0));
  }
}
