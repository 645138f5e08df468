package org.u2sa.world.egocentric;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

class OwnMotionTest {
  private static StateInformation pose(ReferenceFrame imuFrame, ReferenceFrame logFrame) {
    StateInformation imu =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).theta(0.2).psiDot(0.3);
    StateInformation log =
        new StateInformation().referenceFrame(ReferenceFrame.BODY_FRD).xDot(1.0).yDot(0.5);
    OwnMotion own = new OwnMotion();
    for (int tick = 1; tick <= 10; tick++) {
      own.sensed(log.in(logFrame), 100_000L * tick);
      own.sensed(imu.in(imuFrame), 100_000L * tick);
    }
    return own.at(1_000_000L);
  }

  @Test
  void at_sensorsInOtherAxes_isTheSamePose() {
    StateInformation usual = pose(ReferenceFrame.LOCAL_NED, ReferenceFrame.BODY);

    assertThat(usual.psi().orElseThrow()).isGreaterThan(0.2);
    assertThat(usual.x().orElseThrow()).isGreaterThan(0.5);
    assertThat(pose(ReferenceFrame.LOCAL_ENU, ReferenceFrame.BODY_FLU)).isEqualTo(usual);
  }
}
