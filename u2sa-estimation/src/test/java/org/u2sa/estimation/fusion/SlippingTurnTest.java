package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A skid-steered rover without gyroscopes turns on the spot, at half the rate of its wheels. */
class SlippingTurnTest {
  private static final double STEP_S = 0.05;
  private static final double WHEELS_RAD_PER_S = 0.6;

  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final Measurement m = new Measurement();

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_wheelsSlipInATurn_headingFollowsTheCompass(int seed) {
    Random random = new Random(seed);
    double psi = 0.4;
    double worst = 0.0;
    for (int i = 1; i <= 600; i++) {
      long micros = i * 50_000L;
      boolean isTurning = i > 300 && i <= 380;
      double wheels = isTurning ? WHEELS_RAD_PER_S : 0.0;
      psi += STEP_S * 0.5 * wheels;
      m.begin("Wheels", micros);
      m.set(SensedQuantity.BODY_VELOCITY, 0, 0.0, 0.02);
      m.set(SensedQuantity.EULER_RATES, 2, wheels, 0.04);
      filter.add(m);
      if (i % 2 == 0) {
        double heading = Math.IEEEremainder(psi + 0.0175 * random.nextGaussian(), 2.0 * Math.PI);
        filter.add(m.begin("Compass", micros).heading(heading, 0.0175));
      }
      if (i % 4 == 0) {
        Geodetic at =
            SimulatedMotion.HOME.fromNed(
                Point.of(1.0 * random.nextGaussian(), 1.0 * random.nextGaussian(), 0.0));
        filter.add(m.begin("GPS", micros).place(at.latitudeDeg(), at.longitudeDeg(), 1.0, 1.0));
      }
      if (i > 100) {
        double off = Math.IEEEremainder(filter.at(micros).psi() - psi, 2.0 * Math.PI);
        worst = Math.max(worst, Math.abs(off));
      }
    }
    assertThat(Math.toDegrees(worst)).isLessThan(20.0);
  }
}
