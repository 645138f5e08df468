package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
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

  /** A boat on station whose receiver is good, and whose log errs by 2.5 times what is assumed. */
  @Test
  void add_receiverBesideTheLog_errorIsLearnedOnAllAxes() {
    ErrorStateFilter boat = new ErrorStateFilter(FilterTuning.of(MotionDomain.WATER));
    Geodetic home = SimulatedMotion.HOME;
    for (int i = 0; i <= 4_000; i++) {
      long micros = i * 100_000L;
      double latitudeDeg = home.latitudeDeg() + 4e-7 * random.nextGaussian();
      double longitudeDeg = home.longitudeDeg() + 4e-7 * random.nextGaussian();
      m.begin("GPS", micros).place(latitudeDeg, longitudeDeg, 0.05, 0.05);
      boat.add(m.altitude(0.05 * random.nextGaussian(), 0.1));
      boat.add(m.begin("Compass", micros).heading(0.005 * random.nextGaussian(), 0.01));
      m.begin("Log", micros);
      for (int axis = 0; axis < 3 && i % 2 == 0; axis++) {
        double mps = 0.05 + 0.01 * random.nextGaussian();
        m.set(SensedQuantity.BODY_VELOCITY, axis, mps, 0.01);
        m.set(SensedQuantity.FLUID_VELOCITY, axis, mps, 0.05); // the same instrument
      }
      boat.add(m);
    }
    Estimate e = boat.at(400_000_000L);
    for (int axis = 0; axis < 3; axis++) {
      assertThat(e.velocityMps(axis)).as("axis %d", axis).isBetween(-0.025, 0.025);
      assertThat(e.velocitySigmaMps(axis)).as("axis %d", axis).isLessThan(0.012);
    }
    assertThat(e.altitudeM()).isBetween(-0.1, 0.1);
    assertThat((e.latitudeDeg() - home.latitudeDeg()) * 111_200.0).isBetween(-0.1, 0.1);
    assertThat(e.positionSigmaM(2)).isLessThan(0.15);
  }
}
