package org.u2sa.vision.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

class AttitudeHistoryTest {
  private final AttitudeHistory history = new AttitudeHistory();

  private void add(long micros, double rollRad) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.GLOBAL);
    state.phi(rollRad).theta(0.0).timestamp(micros);
    history.add(state);
  }

  @Test
  void roll_betweenTwoStates_isInterpolated() {
    add(100_000_000L, 0.1);
    add(100_100_000L, 0.3);

    assertThat(history.roll(100_050_000L)).isCloseTo(0.2, within(1e-12));
  }

  @Test
  void add_stateThatOvertook_isIgnored() {
    add(100_000_000L, 0.1);
    add(99_900_000L, 0.3);

    assertThat(history.roll(100_000_000L)).isEqualTo(0.1);
  }

  @Test
  void add_clockSetBack_beginsAnew() {
    add(100_000_000L, 0.1);
    add(50_000_000L, 0.3);
    add(50_100_000L, 0.3);

    assertThat(history.roll(50_050_000L)).isEqualTo(0.3);
  }
}
