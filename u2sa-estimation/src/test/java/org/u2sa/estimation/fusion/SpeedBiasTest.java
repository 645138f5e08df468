package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.frame.Geodetic;

/**
 * A velocity log with a constant error carries the position of a submarine that keeps its heading.
 */
class SpeedBiasTest {
  private final Random random = new Random(11);
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.UNDERWATER));

  private void dive(int seconds, double biasX, double biasY) {
    Geodetic home = SimulatedMotion.HOME;
    m.begin("GPS", 0L).place(home.latitudeDeg(), home.longitudeDeg(), 0.05, 0.05);
    filter.add(m);
    for (int i = 1; i <= seconds * 5; i++) {
      long micros = i * 200_000L;
      filter.add(m.begin("Compass", micros).heading(0.005 * random.nextGaussian(), 0.01));
      m.begin("Log", micros);
      m.set(SensedQuantity.BODY_VELOCITY, 0, biasX + 0.01 * random.nextGaussian(), 0.01);
      m.set(SensedQuantity.BODY_VELOCITY, 1, biasY + 0.01 * random.nextGaussian(), 0.01);
      filter.add(m);
    }
  }

  @ParameterizedTest
  @CsvSource({"0.002, 0.0", "0.0, -0.002", "-0.003, 0.003", "0.0, 0.0"})
  void add_constantErrorForFifteenMinutes_sigmaCoversIt(double biasX, double biasY) {
    dive(900, biasX, biasY);
    Estimate e = filter.at(900_000_000L);
    double northErrorM = (e.latitudeDeg() - SimulatedMotion.HOME.latitudeDeg()) * 111_200.0;
    assertThat(northErrorM).isBetween(900.0 * biasX - 0.8, 900.0 * biasX + 0.8);
    assertThat(Math.abs(northErrorM)).isLessThan(3.0 * e.positionSigmaM(0));
    assertThat(e.positionSigmaM(0)).isBetween(1.5, 2.5);
    assertThat(e.positionSigmaM(1)).isBetween(1.5, 2.5);
  }
}
