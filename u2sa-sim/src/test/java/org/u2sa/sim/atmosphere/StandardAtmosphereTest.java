package org.u2sa.sim.atmosphere;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StandardAtmosphereTest {
  // U.S. Standard Atmosphere 1976, table I, geometric altitude; the same as ICAO's up to 32 km
  @ParameterizedTest
  @CsvSource({
    "0, 288.150, 101325, 1.2250, 340.29",
    "1000, 281.651, 89876, 1.1117, 336.43",
    "2000, 275.154, 79501, 1.0066, 332.53",
    "5000, 255.676, 54048, 0.73643, 320.55",
    "8000, 236.215, 35651, 0.52579, 308.11",
    "10000, 223.252, 26500, 0.41351, 299.53",
    "11000, 216.774, 22700, 0.36480, 295.15"
  })
  void at_altitude_isTheTableValue(
      double altitudeM, double kelvin, double pascal, double density, double sound) {
    StandardAtmosphere.Air air = StandardAtmosphere.at(altitudeM);
    assertThat(air.temperatureK()).isCloseTo(kelvin, within(0.002));
    assertThat(air.pressurePa()).isCloseTo(pascal, withinPercentage(0.01));
    assertThat(air.densityKgPerM3()).isCloseTo(density, withinPercentage(0.01));
    assertThat(air.soundSpeedMps()).isCloseTo(sound, within(0.01));
  }

  @Test
  void at_beyondTheTroposphere_staysAtItsBound() {
    assertThat(StandardAtmosphere.at(50_000.0)).isEqualTo(StandardAtmosphere.at(12_000.0));
    assertThat(StandardAtmosphere.at(-9_000.0)).isEqualTo(StandardAtmosphere.at(-2_000.0));
  }

  @Test
  void at_notANumber_isRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> StandardAtmosphere.at(Double.NaN))
        .withMessageContaining("altitude: NaN");
  }

  @Test
  void calibratedAirspeed_atSeaLevel_isTrueAirspeed() {
    assertThat(StandardAtmosphere.at(0.0).calibratedAirspeedMps(60.0))
        .isCloseTo(60.0, within(1e-3));
  }

  @Test
  void calibratedAirspeed_at10000Feet_isTheWheelsOfTheFlightComputer() {
    // 100 KCAS at 10,000 ft, standard: 116 KTAS on any flight computer
    double kcas = StandardAtmosphere.at(3_048.0).calibratedAirspeedMps(116.1 * 0.514444) / 0.514444;
    assertThat(kcas).isCloseTo(100.0, within(0.2));
  }

  @Test
  void trueAirspeed_ofCalibrated_isItsInverse() {
    StandardAtmosphere.Air air = StandardAtmosphere.at(2_500.0);
    assertThat(air.trueAirspeedMps(air.calibratedAirspeedMps(55.0))).isCloseTo(55.0, within(1e-9));
  }
}
