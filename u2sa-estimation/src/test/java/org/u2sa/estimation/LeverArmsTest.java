package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;

/** The text of LEVER ARMS. */
class LeverArmsTest {
  @Test
  void construct_noneOrSeveral_isRead() {
    assertThatCode(() -> new LeverArms("")).doesNotThrowAnyException();
    assertThatCode(() -> new LeverArms("IoioService GPS = 0.4 0 -0.6; DVL=-0.2 0 0.1;"))
        .doesNotThrowAnyException();
  }

  @ParameterizedTest
  @CsvSource({"IMU, 1", "IMU inertial, 1", "GPS, 2", "GPS position, 3", "IMU 2, 0", "Inertial, 0"})
  void place_partOfASensor_hasTheArmOfItsOwnNameElseOfTheSensor(String source, double forward) {
    LeverArms arms = new LeverArms("IMU = 1 0 0; GPS = 2 0 0; GPS position = 3 0 0");
    assertThat(arms.place(new Measurement().begin(source, 0)).mounted(0)).isEqualTo(forward);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "GPS 1 0 0 | \"GPS 1 0 0\": expected",
        "GPS = 1 0 | \"GPS = 1 0\": expected",
        "= 1 0 0 | \"= 1 0 0\": expected",
        "GPS = 1 x 0 | \"x\" is not a number",
        "GPS = 1 NaN 0 | NaN m is outside -100.0…100.0",
        "GPS = 1 0 200 | 200 m is outside",
        "GPS = 1 0 0; GPS = 2 0 0 | GPS appears twice"
      })
  void construct_unreadable_saysWhere(String text, String why) {
    assertThatThrownBy(() -> new LeverArms(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(why);
  }
}
