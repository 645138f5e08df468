package org.u2sa.service.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/** The drift that a state shows. */
class DriftTest {
  private static final Offset<Double> NEAR = within(1e-9);

  /** A state of any frame. */
  private static StateInformation in(ReferenceFrame frame) {
    return new StateInformation().referenceFrame(frame);
  }

  /**
   * Bow to the east, 1 m/s through the water; over ground 1.3 m/s to the east, 0.2 to the north.
   */
  @Test
  void measured_anyFrame_isVelocityOverGroundLessThatThroughTheWater() {
    StateInformation global = in(ReferenceFrame.GLOBAL).xDot(1.3).yDot(0.2).psi(Math.PI / 2.0);
    StateInformation ned = in(ReferenceFrame.LOCAL_NED).xDot(0.2).yDot(1.3).psi(Math.PI / 2.0);
    StateInformation enu = in(ReferenceFrame.LOCAL_ENU).xDot(1.3).yDot(0.2).psi(0.0);

    for (StateInformation state : new StateInformation[] {global, ned, enu}) {
      Drift drift = Drift.measured(state.fluidxDot(1.0)).orElseThrow();
      assertThat(drift.northMps()).as("%s", state).isCloseTo(0.2, NEAR);
      assertThat(drift.eastMps()).as("%s", state).isCloseTo(0.3, NEAR);
    }
  }

  /** Bow to the north, 0.4 m/s to the left through the water, and at rest over ground. */
  @Test
  void measured_movesSidewaysThroughTheWater_isToTheOtherSide() {
    StateInformation state = in(ReferenceFrame.GLOBAL).xDot(0.0).yDot(0.0).psi(0.0);
    Drift drift = Drift.measured(state.fluidxDot(0.0).fluidyDot(0.4)).orElseThrow();

    assertThat(drift.eastMps()).isCloseTo(0.4, NEAR);
    assertThat(drift.northMps()).isCloseTo(0.0, NEAR);
  }

  @Test
  void measured_withoutFluidHeadingOrVelocity_isEmpty() {
    StateInformation whole = in(ReferenceFrame.GLOBAL).xDot(1.0).yDot(0.0);

    assertThat(Drift.measured(whole.copy().psi(0.0))).isEmpty();
    assertThat(Drift.measured(whole.copy().fluidxDot(1.0))).isEmpty();
    assertThat(Drift.measured(in(ReferenceFrame.GLOBAL).psi(0.0).fluidxDot(1.0))).isEmpty();
    assertThat(Drift.measured(in(ReferenceFrame.BODY).xDot(1.0).yDot(0.0).psi(0.0).fluidxDot(1.0)))
        .isEmpty();
  }
}
