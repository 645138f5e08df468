package org.u2sa.vision.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/** Driving north-east at 1 m/s over ramps of 0.15 rad. */
class ClimbedHeightTest {
  private static final double SLOPE = 0.15;
  private static final double PER_M = Math.sin(SLOPE);

  private final ClimbedHeight climbed = new ClimbedHeight(0.035);
  private long micros = 5_000_000;

  private StateInformation state(double pitchRad, double mps) {
    StateInformation state = new StateInformation().theta(pitchRad).psi(Math.PI / 4.0);
    double axis = mps / Math.sqrt(2.0);
    state.referenceFrame(ReferenceFrame.GLOBAL).xDot(axis).yDot(axis).timestamp(micros);
    return state;
  }

  private double after(double pitchRad, double metres) {
    double mps = Math.signum(metres);
    for (int i = 0; i < Math.round(Math.abs(metres) * 20); i++) {
      micros += 50_000;
      climbed.add(state(pitchRad, mps));
    }
    return climbed.metres();
  }

  @Test
  void metres_overARamp_riseStayOnItsTopAndFall() {
    after(0.0, 2.0);
    assertThat(after(SLOPE, 2.0)).isCloseTo(2.0 * PER_M, within(0.01));
    assertThat(after(0.02, 1.4)).as("top").isCloseTo(2.0 * PER_M, within(0.01));
    assertThat(after(-SLOPE, 1.0)).isCloseTo(PER_M, within(0.01));
    assertThat(after(-SLOPE, 1.0)).isCloseTo(0.0, within(0.01));
  }

  @Test
  void metres_onALongTop_end() {
    after(0.0, 1.0);
    after(SLOPE, 2.0);

    assertThat(after(0.0, 3.0)).isZero();
  }

  @Test
  void metres_onAHill_areNoneFarAboveItsFoot() {
    after(0.0, 1.0);

    assertThat(after(SLOPE, 3.0)).isCloseTo(3.0 * PER_M, within(0.01));
    assertThat(after(SLOPE, 47.0)).isZero();
    assertThat(after(-SLOPE, 48.0)).isCloseTo(2.0 * PER_M, within(0.01));
  }

  @Test
  void metres_backDownTheRamp_fall() {
    after(0.0, 1.0);
    after(SLOPE, 1.0);

    assertThat(after(SLOPE, -1.0)).isCloseTo(0.0, within(0.02));
  }

  @Test
  void metres_downhillFirst_areNone() {
    after(0.0, 1.0);

    assertThat(after(-SLOPE, 2.0)).isZero();
  }

  @Test
  void add_lateStateOrLongSilence_doesNotClimb() {
    after(SLOPE, 1.0);
    double before = climbed.metres();
    micros -= 500_000;
    climbed.add(state(SLOPE, 1.0));
    micros += 60_000_000;
    climbed.add(state(SLOPE, 1.0));

    assertThat(climbed.metres()).isEqualTo(before);
  }
}
