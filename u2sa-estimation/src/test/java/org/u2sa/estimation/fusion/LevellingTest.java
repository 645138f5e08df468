package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;

/** A board turned by hand: inertial sensor and compass, and nothing else. */
class LevellingTest {
  private static final double STEP_S = 0.004;
  private static final double GRAVITY = 9.80665;
  private static final double BIAS_RAD_PER_S = 0.03;

  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_turnedBoardWithCompassOnly_isLevelled(int seed) {
    Random random = new Random(seed);
    double worstRad = 0.0;
    for (int i = 1; i <= Math.round(60.0 / STEP_S); i++) {
      double t = i * STEP_S;
      double roll = 0.7 * Math.sin(1.9 * t + seed);
      double pitch = 0.5 * Math.sin(1.3 * t);
      double yaw = 0.4 * Math.sin(0.5 * t);
      double rollRate = 0.7 * 1.9 * Math.cos(1.9 * t + seed);
      double pitchRate = 0.5 * 1.3 * Math.cos(1.3 * t);
      double yawRate = 0.4 * 0.5 * Math.cos(0.5 * t);
      double p = rollRate - yawRate * Math.sin(pitch);
      double q = pitchRate * Math.cos(roll) + yawRate * Math.sin(roll) * Math.cos(pitch);
      double r = -pitchRate * Math.sin(roll) + yawRate * Math.cos(roll) * Math.cos(pitch);
      double jerk = t < 0.2 ? 8.0 : 0.0; // when it is picked up
      long micros = Math.round(t * 1e6);
      m.begin("IMU", micros)
          .bodyRates(
              p + BIAS_RAD_PER_S + 0.003 * random.nextGaussian(),
              q - BIAS_RAD_PER_S + 0.003 * random.nextGaussian(),
              r + 0.003 * random.nextGaussian(),
              0.005)
          .specificForce(
              GRAVITY * Math.sin(pitch) + 0.3 * random.nextGaussian(),
              jerk - GRAVITY * Math.sin(roll) * Math.cos(pitch) + 0.3 * random.nextGaussian(),
              -GRAVITY * Math.cos(roll) * Math.cos(pitch) + 0.3 * random.nextGaussian(),
              0.3);
      filter.add(m);
      if (i % 5 == 0) {
        filter.add(m.begin("Compass", micros).heading(yaw + 0.03 * random.nextGaussian(), 0.03));
      }
      if (t > 20.0 && i % 25 == 0) {
        Estimate e = filter.at(micros);
        worstRad = Math.max(worstRad, Math.abs(e.phi() - roll));
        worstRad = Math.max(worstRad, Math.abs(e.theta() - pitch));
      }
    }
    assertThat(Math.toDegrees(worstRad)).isLessThan(3.0);
  }
}
