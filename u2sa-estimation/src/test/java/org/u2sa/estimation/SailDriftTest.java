package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

class SailDriftTest {
  private final SailDrift drift =
      new SailDrift(Set.of("Wind"), new SailDrift.Hull(0.5, 60.0, 40.0, 90.0), 0.3, 0.2);

  private StateInformation windFromTheLeft(String sensor, double timeS) {
    StateInformation sensed = new StateInformation().sensorName(sensor);
    sensed.referenceFrame(ReferenceFrame.BODY).timestamp(Math.round(timeS * 1e6));
    return drift.throughWater(sensed.fluidxDot(1.0).fluidyDot(6.0));
  }

  @Test
  void throughWater_steadyWind_dragOfTheHullEqualsThatOfTheSail() {
    StateInformation last = windFromTheLeft("Wind", 0.0);
    for (int i = 1; i <= 100; i++) {
      last = windFromTheLeft("Wind", 0.25 * i);
    }
    double right = -last.fluidyDot().orElseThrow();

    assertThat(right).isCloseTo(0.159, within(0.001));
    assertThat(40.0 * right + 90.0 * right * right).isCloseTo(0.24 * 36.0, within(0.01));
    assertThat(last.fluidxDot()).as("ahead, thrusters decide").isEmpty();
    assertThat(last.fluidyDotSigma().orElseThrow())
        .isCloseTo(Math.hypot(0.3, 0.0795), within(0.001));
  }

  @Test
  void throughWater_withinTheInterval_isLeftOut() {
    windFromTheLeft("Wind", 0.0);

    assertThat(windFromTheLeft("Wind", 0.1).fluidyDot()).isEmpty();
    assertThat(windFromTheLeft("Wind", 0.2).fluidyDot()).isPresent();
  }

  @Test
  void throughWater_otherSensor_staysAsItIs() {
    assertThat(windFromTheLeft("Log", 0.0).fluidyDot()).hasValue(6.0);
  }
}
