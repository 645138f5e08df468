package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class WheelSpeedsProperties {
  private static final double TRACK_M = 0.5;
  private static final double MAX_MPS = 1.5;

  @Property
  void of_anyDrive_noWheelIsFasterThanItCanAndTheCurvatureStays(
      @ForAll @DoubleRange(min = -3.0, max = 3.0) double speed,
      @ForAll @DoubleRange(min = -6.0, max = 6.0) double yawRate) {
    WheelSpeeds wheels = WheelSpeeds.of(new Drive(speed, yawRate), TRACK_M, MAX_MPS);

    assertThat(Math.abs(wheels.leftMps())).isLessThanOrEqualTo(MAX_MPS + 1.0e-9);
    assertThat(Math.abs(wheels.rightMps())).isLessThanOrEqualTo(MAX_MPS + 1.0e-9);
    Drive driven = wheels.drive(TRACK_M);
    assertThat(driven.yawRateRadPerS() * speed)
        .isCloseTo(driven.speedMps() * yawRate, within(1.0e-9));
    assertThat(driven.speedMps() * speed).isNotNegative();
  }

  @Property
  void of_driveThatTheWheelsCanDo_isDrivenAsItIs(
      @ForAll @DoubleRange(min = -0.7, max = 0.7) double speed,
      @ForAll @DoubleRange(min = -3.0, max = 3.0) double yawRate) {
    Drive driven = WheelSpeeds.of(new Drive(speed, yawRate), TRACK_M, MAX_MPS).drive(TRACK_M);

    assertThat(driven.speedMps()).isCloseTo(speed, within(1.0e-9));
    assertThat(driven.yawRateRadPerS()).isCloseTo(yawRate, within(1.0e-9));
  }
}
