package org.u2sa.trials.simulate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;

/** The score of a heading that is exact has no error, wherever on earth. */
class HeadingErrorTest {
  private static final double TRUE_RAD = 1.0;

  @ParameterizedTest
  @CsvSource({"49.0, 300", "-89.99, 300", "-89.99, -800", "89.999, 50"})
  void headingError_exactStateInEachFrame_isZero(double latitudeDeg, double eastM) {
    Geodetic origin = new Geodetic(8.0, latitudeDeg, 0.0);
    StateInformation exact =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(40.0)
            .y(eastM)
            .z(0.0)
            .psi(TRUE_RAD);

    for (ReferenceFrame frame :
        new ReferenceFrame[] {
          ReferenceFrame.GLOBAL, ReferenceFrame.LOCAL_NED, ReferenceFrame.LOCAL_ENU
        }) {
      StateInformation state = exact.in(frame, origin);
      assertThat(EstimateScorer.headingError(state, TRUE_RAD, origin).orElseThrow())
          .as(frame.toString())
          .isCloseTo(0.0, within(1e-6));
    }
  }

  @Test
  void headingError_noHeading_isEmpty() {
    StateInformation place =
        new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).x(8.0).y(47.0);

    assertThat(EstimateScorer.headingError(place, TRUE_RAD, new Geodetic(8.0, 47.0, 0.0)))
        .isEmpty();
  }
}
