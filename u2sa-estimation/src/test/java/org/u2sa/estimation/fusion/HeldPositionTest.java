package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A receiver whose positions are held, drift or are rounded while the vehicle drives north. */
class HeldPositionTest {
  private static final double SPEED_MPS = 0.8;
  private static final double SIGMA_M = 0.02;

  private final Random random = new Random(3);
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private long micros;
  private double worst;
  private double worstSigmas;
  private double driftMps;
  private double driftM;
  private double stepM; // to which positions are rounded; 0: not
  private boolean hasImu;

  private void drive(double seconds, boolean isHeld, double heldNoise, double shownMps) {
    double held = SPEED_MPS * micros * 1e-6;
    for (int i = 1; i <= seconds * 20; i++) {
      micros += 50_000;
      double north = SPEED_MPS * micros * 1e-6;
      m.begin("Compass", micros).heading(0.01 * random.nextGaussian(), 0.01);
      filter.add(m);
      m.begin("Wheels", micros).forward(SPEED_MPS + 0.02 * random.nextGaussian(), 0.02);
      filter.add(m);
      if (hasImu) {
        filter.add(imu());
      }
      driftM += 0.05 * driftMps;
      if (i % 2 == 0) {
        double noise = isHeld ? heldNoise : SIGMA_M;
        double shown = (isHeld ? held : north) + noise * random.nextGaussian();
        shown += driftM;
        shown = stepM > 0.0 ? stepM * Math.rint(shown / stepM) : shown;
        Geodetic at = SimulatedMotion.HOME.fromNed(Point.of(shown, 0.0, 0.0));
        m.begin("GPS", micros)
            .place(at.latitudeDeg(), at.longitudeDeg(), SIGMA_M, SIGMA_M)
            .altitude(5.0 + 0.1 * random.nextGaussian(), 0.1)
            .velocity((isHeld ? shownMps : SPEED_MPS) + velocityNoise(), velocityNoise(), 0.3);
        filter.add(m);
      }
      worst = i == 1 ? worst : Math.max(worst, Math.abs(off(north))); // the first comes with i = 2
      if (i > 1 && micros > 10_000_000L) {
        double sigma = filter.at(micros).positionSigmaM(0);
        worstSigmas = Math.max(worstSigmas, Math.abs(off(north)) / sigma);
      }
    }
  }

  private double velocityNoise() {
    return hasImu ? 0.05 * random.nextGaussian() : 0.0;
  }

  private Measurement imu() {
    m.begin("IMU", micros);
    m.bodyRates(noise(1e-3), noise(1e-3), noise(1e-3), 1e-3);
    return m.specificForce(noise(0.05), noise(0.05), noise(0.05) - 9.795, 0.05);
  }

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  private double off(double north) {
    Estimate e = filter.at(micros);
    Geodetic said = new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 0.0);
    return SimulatedMotion.HOME.nedOf(said).x() - north;
  }

  @Test
  void add_placeRepeatsWhileAltitudesGoOn_receiverIsFrozen() {
    drive(20.0, false, 0.0, 0.0);
    drive(30.0, true, 0.0, 0.0);
    assertThat(worst).isLessThan(0.3);
    assertThat(filter.sources().at(micros).toString()).contains("source=GPS, standing=FROZEN");
    drive(10.0, false, 0.0, 0.0);
    assertThat(filter.sources().at(micros).toString()).contains("source=GPS, standing=USED");
  }

  @Test
  void add_placeIsHeldWithNoiseButVelocityGoesOn_wheelsAreBelieved() {
    drive(20.0, false, 0.0, 0.0);
    drive(30.0, true, 0.003, SPEED_MPS);
    assertThat(worst).isLessThan(0.6);
    assertThat(filter.at(micros).velocityMps(0)).isBetween(0.7, 0.9);
  }

  @ParameterizedTest
  @CsvSource({"0.3, true", "-0.3, true", "0.5, true", "1.0, true", "0.3, false", "1.0, false"})
  void add_placeDriftsButVelocityAndWheelsAgree_receiverIsNamedAndLeftOut(
      double mps, boolean withImu) {
    hasImu = withImu;
    drive(30.0, false, 0.0, 0.0);
    driftMps = mps;
    drive(40.0, false, 0.0, 0.0);
    assertThat(worst).isLessThan(1.2);
    assertThat(worstSigmas).isLessThan(4.0);
    assertThat(filter.sources().at(micros).toString()).contains("source=GPS, standing=BIASED");
  }

  @Test
  void add_placeHasDriftedAwayAndBack_receiverIsUsedAgain() {
    hasImu = true;
    drive(30.0, false, 0.0, 0.0);
    driftMps = 0.3;
    drive(20.0, false, 0.0, 0.0);
    driftMps = -0.3;
    drive(20.0, false, 0.0, 0.0);
    driftMps = 0.0;
    drive(10.0, false, 0.0, 0.0);
    assertThat(filter.sources().at(micros).toString()).contains("source=GPS, standing=USED");
    assertThat(filter.at(micros).positionSigmaM(0)).isLessThan(0.1);
    assertThat(off(SPEED_MPS * micros * 1e-6)).isBetween(-0.06, 0.06);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void add_placeIsRounded_sigmaCoversTheStep(boolean withImu) {
    hasImu = withImu;
    stepM = 1.0;
    drive(60.0, false, 0.0, 0.0);
    assertThat(worstSigmas).isLessThan(3.0);
    assertThat(filter.at(micros).positionSigmaM(0)).isBetween(0.1, 0.6);
  }
}
