package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

class SensedMotionTest {
  private static BodyMotion motion(ReferenceFrame imuFrame, ReferenceFrame logFrame) {
    StateInformation imu =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .phi(0.1)
            .theta(0.2)
            .psiDot(0.3);
    StateInformation log =
        new StateInformation()
            .referenceFrame(ReferenceFrame.BODY_FRD)
            .xDot(1.0)
            .yDot(0.5)
            .zDot(-0.25);
    SensedMotion sensed = new SensedMotion();
    sensed.sensed(imu.in(imuFrame), 0L);
    sensed.sensed(log.in(logFrame), 0L);
    return sensed.now(0L).orElseThrow();
  }

  @Test
  void now_sensorsInAnyAxes_isTheSameMotion() {
    BodyMotion usual = motion(ReferenceFrame.LOCAL_NED, ReferenceFrame.BODY);
    for (ReferenceFrame log : List.of(ReferenceFrame.BODY_FRD, ReferenceFrame.BODY_FLU)) {
      assertThat(motion(ReferenceFrame.LOCAL_ENU, log)).usingRecursiveComparison().isEqualTo(usual);
    }
  }
}
