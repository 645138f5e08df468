package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LandingRefusalTest {
  private static final double DT_S = 0.02;
  private static final double WIND_MPS = 14.0; // from the left

  private final WindEstimate wind = new WindEstimate();
  private final FinalApproach approach = new FinalApproach();

  private static FlightState at(double northM, double heightM) {
    return new FlightState(
        0, northM, 0, heightM, heightM, 0, 0, 0, 0, 0, 0, 20, WIND_MPS, -2, 20, 20, 0, 0, false, 0,
        false, false, true);
  }

  /** Navigation descends, stays at a height for a while, and leads up again. */
  @ParameterizedTest
  @ValueSource(doubles = {5.0, 12.0, 20.0, 29.0, 35.0, 39.0, 41.0})
  void step_navigationLeadsDownAndUpAgain_isRefusedOnceAtMost(double lowestM) {
    for (double safeHeightM : new double[] {20.0, 30.0, 100.0}) {
      LandingRefusal refusal = new LandingRefusal(11.0, safeHeightM, 3.0);
      int changes = 0;
      boolean before = false;
      for (int i = 0; i < 4000; i++) {
        double ledToM = Math.max(lowestM, 60.0 - 0.04 * i) + Math.max(0.0, 0.04 * (i - 2500));
        FlightState state = at(20.0 * DT_S * i, ledToM + 10.0);
        GuidanceTarget target = new GuidanceTarget(100.0, 0.0, ledToM, OptionalDouble.empty());
        wind.step(state, DT_S);
        approach.see(state, target, DT_S);
        boolean refuses = refusal.step(state, Optional.of(target), wind, approach);
        changes += refuses == before ? 0 : 1;
        before = refuses;
      }
      boolean isLow = lowestM < Math.min(safeHeightM, 42.0) - 2.0;
      assertThat(changes).as("SAFE HEIGHT %s", safeHeightM).isEqualTo(isLow ? 2 : 0);
    }
  }
}
