package org.u2sa.sim.atmosphere;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class WindTest {
  private static final double FOOT = 0.3048;

  @Test
  void step_windFromTheWest_blowsEast() {
    WindField field = field(Wind.constant(Math.toRadians(270.0), 8.0), 100.0);
    assertThat(field.eastMps()).isCloseTo(8.0, within(1e-12));
    assertThat(field.northMps()).isCloseTo(0.0, within(1e-12));
    assertThat(field.downMps()).isZero();
  }

  @Test
  void step_profile_followsTheLogarithmicLaw() {
    // MIL-F-8785C, 3.7.3.4: u = u20 ln(h / 0.15 ft) / ln(20 ft / 0.15 ft)
    Wind wind = new Wind(Math.PI, 5.0, WindProfile.military(), 0.0, 0L);
    assertThat(field(wind, 20.0 * FOOT).northMps()).isCloseTo(5.0, within(1e-9));
    assertThat(field(wind, 500.0 * FOOT).northMps()).isCloseTo(8.289, within(0.002));
    assertThat(field(wind, 9_000.0).northMps()).isEqualTo(field(wind, 1_000.0 * FOOT).northMps());
    assertThat(field(wind, 0.0).northMps()).isCloseTo(3.061, within(0.002));
  }

  @Test
  void turbulent_wind_hasATenthOfItInVerticalGusts() {
    assertThat(Wind.turbulent(0.0, 8.0, 1L).gustSigmaMps()).isCloseTo(0.8, within(1e-12));
  }

  @Test
  void new_badNumbers_areRefusedByName() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Wind.constant(0.0, -1.0))
        .withMessage("wind speed [m/s]: -1.0 is outside 0.0…60.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Wind.constant(Double.NaN, 1.0))
        .withMessageContaining("wind direction [rad]: NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Wind.calm().withGusts(Double.NaN, 1L))
        .withMessageContaining("gust sigma [m/s]: NaN");
  }

  private static WindField field(Wind wind, double heightM) {
    WindField field = new WindField(wind, 10.97);
    field.step(0.01, heightM, 50.0, 1.0, 0.0);
    return field;
  }
}
