package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;

/** Two sound inertial sensors on a vehicle that begins to turn within a few samples. */
class QuickTurnTest {
  private static final String OTHER = "IMU 2";

  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_bothInertialSensorsSound_neitherIsBiased(int seed) {
    SimulatedMotion motion = new SimulatedMotion(seed);
    double[] none = new double[6];
    for (int i = 1; i <= 2_000; i++) {
      motion.fly(0.5, i < 1_000 ? 0.05 : 2.0);
      filter.add(motion.imu(m, "IMU", none, 0.003, 0.05));
      filter.add(motion.imu(m, OTHER, none, 0.003, 0.05));
      if (i % 10 == 0) {
        filter.add(motion.compass(m, "Compass", Math.toRadians(2.0)));
        filter.add(motion.fix(m, "GPS", 0.05, 0.05, 1.0));
      }
      assertThat(filter.sources().at(motion.micros))
          .as("after %d steps", i)
          .filteredOn(each -> each.source().contains("IMU"))
          .noneMatch(each -> each.standing() == SourceReports.Standing.BIASED);
    }
  }
}
