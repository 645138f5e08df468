package org.u2sa.messages.frame;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MagneticModelTest {
  private static final double PRINTED_DEG = 0.006; // the values are rounded to 0.01 deg

  /** Table of test values of the WMM2025 technical report, and of WMM2025_TestValues.txt. */
  @ParameterizedTest
  @CsvSource({
    "2025.0,   0,  80,    0,   1.28",
    "2025.0,   0,   0,  120,  -0.16",
    "2025.0,   0, -80,  240,  68.78",
    "2025.0, 100,  80,    0,   0.85",
    "2025.0, 100,   0,  120,  -0.15",
    "2025.0, 100, -80,  240,  68.21",
    "2027.5,   0,  80,    0,   2.59",
    "2027.5,   0,   0,  120,  -0.24",
    "2027.5,   0, -80,  240,  68.49",
    "2027.5, 100,  80,    0,   2.16",
    "2027.5, 100,   0,  120,  -0.23",
    "2027.5, 100, -80,  240,  67.93",
    "2025.0,  28,  89, -121, -99.77",
    "2025.0,  48,  80,  -96, -29.91",
    "2025.0,  18,   0,   21,   1.29",
    "2025.5,   6, -36, -137,  20.28",
    "2025.0,  65,  43,   93,   0.50"
  })
  void declination_publishedTestValue_isMet(
      double year, double altitudeKm, double latitude, double longitude, double declinationDeg) {
    double found = MagneticModel.declinationRad(latitude, longitude, 1000.0 * altitudeKm, year);

    assertThat(Math.toDegrees(found)).isCloseTo(declinationDeg, within(PRINTED_DEG));
  }

  @Test
  void declination_clockNeverSet_isThatOfTheFirstYear() {
    assertThat(MagneticModel.declinationRad(37.2, -80.4, 600.0, 1970.0))
        .isEqualTo(MagneticModel.declinationRad(37.2, -80.4, 600.0, 2025.0));
  }

  @Test
  void declination_atAPole_isANumber() {
    assertThat(MagneticModel.declinationRad(90.0, 0.0, 0.0, 2026.0)).isBetween(-Math.PI, Math.PI);
    assertThat(MagneticModel.declinationRad(-90.0, 0.0, 0.0, 2026.0)).isBetween(-Math.PI, Math.PI);
  }

  @Test
  void declination_latitudeBeyondThePole_isRefused() {
    assertThatThrownBy(() -> MagneticModel.declinationRad(90.1, 0.0, 0.0, 2026.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("latitude: 90.1 is outside -90…90 deg");
  }
}
