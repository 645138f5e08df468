package org.u2sa.interfaces.units;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class UnitsTest {
  // Right-hand sides: NIST SP 811 (2008), appendix B.8, and arithmetic by hand.
  @ParameterizedTest
  @CsvSource({
    "3000, ft, m, 914.4",
    "1, nmi, m, 1852",
    "1, mi, km, 1.609344",
    "12, in, ft, 1",
    "180, deg, rad, 3.141592653589793",
    "1, °, deg, 1",
    "100, kt, m/s, 51.44444444444444",
    "36, km/h, m/s, 10",
    "1, mph, m/s, 0.44704",
    "500, ft/min, m/s, 2.54",
    "500, fpm, m/s, 2.54",
    "60, rpm, rad/s, 6.283185307179586",
    "1, g, m/s^2, 9.80665",
    "1, ft/s^2, m/s², 0.3048",
    "250, ms, s, 0.25",
    "2, h, min, 120",
    "50, %, 1, 0.5",
    "120, %/rad, %/deg, 2.0943951023931953",
    "1000, 1/s, kHz, 1",
    "29.92, inHg, hPa, 1013.2075888",
    "1, psi, Pa, 6894.757293168361",
    "15, degC, K, 288.15",
    "59, degF, degC, 15",
    "1, kHz, Hz, 1000",
    "1, lbf, N, 4.4482216152605",
    "7, furlong, furlong, 7",
  })
  void convert_knownPair_hasTheTabulatedValue(
      double value, String from, String to, double expected) {
    assertThat(Units.convert(value, from, to)).isCloseTo(expected, within(1.0e-12 * expected));
  }

  @Test
  void convert_degrees_equalsJavasOwn() {
    for (int degrees = -360; degrees <= 360; degrees++) {
      assertThat(Units.convert(degrees, "deg", "rad")).isEqualTo(Math.toRadians(degrees));
    }
  }

  @Test
  void convert_unknownUnit_listsThoseOfTheDimension() {
    assertThatThrownBy(() -> Units.convert(1.0, "fathom", "m"))
        .hasMessage("unknown unit \"fathom\"; expected length: m, km, cm, mm, ft, in, nmi, NM, mi");
  }

  @Test
  void convert_anotherDimension_namesBoth() {
    assertThatThrownBy(() -> Units.convert(1.0, "kt", "rad"))
        .hasMessage("unit \"kt\" measures speed, expected angle: rad, deg, °");
  }

  @Test
  void convert_quotientOfOtherDimension_namesBoth() {
    assertThatThrownBy(() -> Units.convert(1.0, "m", "%/rad"))
        .hasMessage("unit \"m\" measures length, expected ratio per angle: %/rad");
  }

  @Test
  void convert_targetWithoutTable_takesNothingElse() {
    assertThatThrownBy(() -> Units.convert(1.0, "m", "smoots"))
        .hasMessage("unit \"m\" cannot be converted to \"smoots\"; expected \"smoots\"");
  }
}
