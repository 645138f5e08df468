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

/** A receiver whose positions are held, drift, are rounded or repeated while a vehicle drives. */
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
  private double stepDeg; // to which positions are rounded; 0: not
  private boolean hasImu;
  private double eastMps;
  private int fixSteps = 2; // steps of 0.05 s per fix
  private boolean isRepeated; // each fix, after 2 ms

  private void drive(double seconds, boolean isHeld, double heldNoise, double shownMps) {
    double held = SPEED_MPS * micros * 1e-6;
    for (int i = 1; i <= seconds * 20; i++) {
      micros += 50_000;
      double north = SPEED_MPS * micros * 1e-6;
      double east = eastMps * micros * 1e-6;
      double heading = StrictMath.atan2(eastMps, SPEED_MPS);
      m.begin("Compass", micros).heading(heading + 0.01 * random.nextGaussian(), 0.01);
      filter.add(m);
      double forward = Math.hypot(eastMps, SPEED_MPS);
      m.begin("Wheels", micros).forward(forward + 0.02 * random.nextGaussian(), 0.02);
      filter.add(m);
      if (hasImu) {
        filter.add(imu());
      }
      driftM += 0.05 * driftMps;
      if (i % fixSteps == 0) {
        double noise = isHeld ? heldNoise : SIGMA_M;
        double shown = (isHeld ? held : north) + noise * random.nextGaussian();
        Geodetic at = SimulatedMotion.HOME.fromNed(Point.of(shown + driftM, east, 0.0));
        fix(at.latitudeDeg(), at.longitudeDeg(), isHeld ? shownMps : SPEED_MPS);
      }
      worst =
          i == 1
              ? worst
              : Math.max(worst, Math.abs(off(north, east).x())); // the first comes with i = 2
      if (i > 1 && micros > 10_000_000L) {
        Estimate e = filter.at(micros);
        Point off = off(north, east);
        worstSigmas = Math.max(worstSigmas, Math.abs(off.x()) / e.positionSigmaM(0));
        worstSigmas = Math.max(worstSigmas, Math.abs(off.y()) / e.positionSigmaM(1));
      }
    }
  }

  private void fix(double latitudeDeg, double longitudeDeg, double northMps) {
    double y = stepDeg > 0.0 ? stepDeg * Math.rint(latitudeDeg / stepDeg) : latitudeDeg;
    double x = stepDeg > 0.0 ? stepDeg * Math.rint(longitudeDeg / stepDeg) : longitudeDeg;
    m.begin("GPS", micros)
        .place(y, x, SIGMA_M, SIGMA_M)
        .altitude(5.0 + 0.1 * random.nextGaussian(), 0.1)
        .velocity(northMps + velocityNoise(), eastMps + velocityNoise(), 0.3);
    filter.add(m);
    if (isRepeated) {
      m.begin("GPS", micros + 2000);
      filter.add(m.place(y, x, SIGMA_M, SIGMA_M));
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

  private Point off(double north, double east) {
    Estimate e = filter.at(micros);
    Geodetic said = new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 0.0);
    Point at = SimulatedMotion.HOME.nedOf(said);
    return Point.of(at.x() - north, at.y() - east, 0.0);
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
    assertThat(off(SPEED_MPS * micros * 1e-6, 0.0).x()).isBetween(-0.06, 0.06);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void add_placeIsRounded_sigmaCoversTheStep(boolean withImu) {
    hasImu = withImu;
    stepDeg = 1e-5; // 1.1 m
    eastMps = 0.5;
    drive(60.0, false, 0.0, 0.0);
    assertThat(worstSigmas).isLessThan(3.0);
    assertThat(filter.at(micros).positionSigmaM(0)).isBetween(0.1, 0.6);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void add_fixesAreRepeated_sigmaIsTheirs(boolean withImu) {
    hasImu = withImu;
    isRepeated = true;
    fixSteps = 20;
    eastMps = 1.5;
    drive(10.0, false, 0.0, 0.0);
    worst = 0.0;
    drive(50.0, false, 0.0, 0.0);
    assertThat(worst).isLessThan(0.15);
    assertThat(filter.at(micros).positionSigmaM(0)).isLessThan(0.1);
  }
}
