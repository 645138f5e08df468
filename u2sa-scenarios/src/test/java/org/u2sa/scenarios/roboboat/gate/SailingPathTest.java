package org.u2sa.scenarios.roboboat.gate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Pose;

class SailingPathTest {
  private final SailingPath northward = northward();

  private static SailingPath northward() {
    List<Pose> poses = new ArrayList<>();
    for (int i = 0; i <= 40; i++) {
      poses.add(new Pose(i * SailingPath.SPACING_M, 0.0, 0.0));
    }
    return new SailingPath(poses);
  }

  @Test
  void ahead_boatBesideThePath_isOnThePath() {
    northward.follow(Point.of(2.0, 0.7, 0.0));

    assertThat(northward.ahead(2.0)).isEqualTo(Point.of(4.0, 0.0, 0.0));
    assertThat(northward.offM(Point.of(2.0, 0.7, 0.0))).isCloseTo(0.7, within(1e-9));
  }

  @Test
  void ahead_pastTheEnd_isStraightOn() {
    for (double north = 0.0; north < 9.6; north += 0.5) {
      northward.follow(Point.of(north, 0.0, 0.0));
    }

    assertThat(northward.leftM()).isCloseTo(0.5, within(1e-9));
    assertThat(northward.ahead(2.0)).isEqualTo(Point.of(11.5, 0.0, 0.0));
  }

  @Test
  void follow_boatThatDriftsBack_keepsItsProgress() {
    northward.follow(Point.of(2.0, 0.0, 0.0));
    northward.follow(Point.of(0.0, 0.0, 0.0));

    assertThat(northward.ahead(1.0)).isEqualTo(Point.of(3.0, 0.0, 0.0));
  }
}
