package org.u2sa.world.modeller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

class PoseHistoryTest {
  private static StateInformation state(ReferenceFrame frame, double x) {
    return new StateInformation().referenceFrame(frame).x(x).y(10.0).psi(0.0);
  }

  @ParameterizedTest
  @CsvSource({
    "179.9, -179.7, 0.75, -179.8",
    "-179.7, 179.9, 0.25, -179.8",
    "179.9, -179.7, 0.125, 179.95",
    "8.0, 8.4, 0.5, 8.2",
    "-0.2, 0.2, 0.25, -0.1"
  })
  void between_globalStates_goesTheShorterWayRound(
      double from, double to, double share, double expected) {
    StateInformation between =
        PoseHistory.between(
            state(ReferenceFrame.GLOBAL, from), state(ReferenceFrame.GLOBAL, to), share);
    assertThat(between.x().orElseThrow()).isCloseTo(expected, within(1e-9));
  }

  @Test
  void between_localStates_areFarApartInMetres() {
    StateInformation between =
        PoseHistory.between(
            state(ReferenceFrame.LOCAL_ENU, -200.0), state(ReferenceFrame.LOCAL_ENU, 200.0), 0.75);
    assertThat(between.x().orElseThrow()).isCloseTo(100.0, within(1e-9));
  }
}
