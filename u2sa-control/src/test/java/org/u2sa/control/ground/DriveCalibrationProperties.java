package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class DriveCalibrationProperties {
  @Property
  void share_anySpeed_isTheCommandAtWhichItGoesThatFast(
      @ForAll @DoubleRange(min = -3.0, max = 3.0) double mps,
      @ForAll @DoubleRange(min = 0.1, max = 5.0) double maxMps,
      @ForAll @DoubleRange(min = 0.0, max = 0.5) double start) {
    DriveCalibration motor = new DriveCalibration(maxMps, start);

    assertThat(motor.speedMps(motor.share(mps))).isCloseTo(mps, within(1.0e-5));
  }

  @Test
  void share_standing_isNothing() {
    assertThat(new DriveCalibration(2.0, 0.08).share(0.0)).isZero();
    assertThat(new DriveCalibration(2.0, 0.08).share(2.0)).isEqualTo(1.0);
    assertThat(new DriveCalibration(2.0, 0.08).share(-2.0)).isEqualTo(-1.0);
  }
}
