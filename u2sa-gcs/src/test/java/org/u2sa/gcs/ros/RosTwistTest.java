package org.u2sa.gcs.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.safety.ManualDrive;

/** Twists of ROS tools as motion wanted by hand. */
class RosTwistTest {
  @Test
  void drive_speedAndTurn_areThoseOfLinearXAndAngularZ() {
    ManualDrive drive =
        RosTwist.drive(Map.of("linear", Map.of("x", 0.5), "angular", Map.of("z", -0.25)), "Ann");

    assertThat(drive.operator()).isEqualTo("Ann");
    assertThat(drive.speed().orElseThrow()).isEqualTo(0.5);
    assertThat(drive.turnRate().orElseThrow()).isEqualTo(-0.25);
    assertThat(RosTwist.drive(Map.of(), "Ann").speed().orElseThrow()).isZero();
  }

  @ParameterizedTest
  @CsvSource({"linear, y", "linear, z", "angular, x", "angular, y"})
  void drive_otherComponents_areRefusedByName(String vector, String axis) {
    assertThatThrownBy(() -> RosTwist.drive(Map.of(vector, Map.of(axis, 0.1)), "Ann"))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith(vector + "." + axis + ": expected 0");
  }

  @Test
  void drive_notANumber_isRefused() {
    assertThatThrownBy(() -> RosTwist.drive(Map.of("linear", Map.of("x", "fast")), "Ann"))
        .hasMessageStartingWith("linear.x: expected a finite number");
  }
}
