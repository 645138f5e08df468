package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;

/** Measured speed and turn rate drive the prediction where there is no inertial sensor. */
class MotionInputTest {
  private static final long STEP_MICROS = 100_000;

  private final Random random = new Random(4);
  private final Measurement m = new Measurement();
  private ErrorStateFilter filter;
  private double north;
  private double east;
  private double psi;

  private void start() {
    filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
    filter.add(m.begin("Start", 0).localPlace(0.0, 0.0, 0.001).heading(0.0, 1e-4));
    north = 0.0;
    east = 0.0;
    psi = 0.0;
  }

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  /** In and out of bends at up to 1 m/s: wheels measure both with that noise. */
  private void drive(double seconds, double speedSigma, double turnSigma) {
    for (int i = 1; i <= seconds * 10; i++) {
      double speed = Math.min(1.0, 0.05 * i);
      double turn = 0.4 * Math.sin(0.05 * i);
      double middle = psi + 0.05 * turn;
      north += 0.1 * speed * Math.cos(middle);
      east += 0.1 * speed * Math.sin(middle);
      psi += 0.1 * turn;
      m.begin("Wheels", i * STEP_MICROS - STEP_MICROS / 2);
      m.forward(speed + noise(speedSigma), Math.max(0.001, speedSigma));
      filter.add(m.turnRate(turn + noise(turnSigma), Math.max(0.001, turnSigma)));
    }
  }

  private Estimate estimate(double seconds) {
    return filter.at((long) (seconds * 1e6));
  }

  @Test
  void add_preciseTurnRate_headingIsIntegratedAndTheClaimIsThatOfIntegration() {
    start();
    drive(10.0, 0.01, 0.01);
    Estimate e = estimate(10.0);
    // 0.01 rad/s, new at each of 100 tenths of a second: 0.01 · 0.1 · √100 rad = 0.57°
    assertThat(Math.toDegrees(e.attitudeSigma(2))).isBetween(0.3, 1.5);
    double off = Math.IEEEremainder(e.psi() - psi, 2.0 * Math.PI);
    assertThat(Math.abs(off)).isLessThan(3.0 * e.attitudeSigma(2));
  }

  @Test
  void add_wheelsOnly_wayIsThatOfTheWheels() {
    start();
    drive(60.0, 0.0, 0.0);
    Estimate e = estimate(60.0);
    assertThat(e.localM(0)).isCloseTo(north, within(0.2));
    assertThat(e.localM(1)).isCloseTo(east, within(0.2));
  }

  /**
   * Mean squared errors over claimed variances, of 40 drives; the 99.9 % bounds are 0.4 and 1.9.
   */
  @Test
  void add_noisyWheels_claimsAreThoseOfTheErrors() {
    double heading = 0.0;
    double position = 0.0;
    int runs = 40;
    for (int run = 0; run < runs; run++) {
      start();
      drive(20.0, 0.05, 0.05);
      Estimate e = estimate(20.0);
      double off = Math.IEEEremainder(e.psi() - psi, 2.0 * Math.PI) / e.attitudeSigma(2);
      double across = (e.localM(0) - north) / e.positionSigmaM(0);
      double along = (e.localM(1) - east) / e.positionSigmaM(1);
      heading += off * off / runs;
      position += (across * across + along * along) / 2.0 / runs;
    }
    assertThat(heading).isBetween(0.4, 1.9);
    assertThat(position).as("no wheel-speed scale was wrong").isBetween(0.2, 1.9);
  }

  /** A slow source says too little of what happens between its samples. */
  @Test
  void add_turnRateEverySecond_isAMeasurementAmongOthers() {
    start();
    for (int i = 1; i <= 10; i++) {
      filter.add(m.begin("Slow", i * 1_000_000L).turnRate(0.0, 0.01));
    }
    assertThat(estimate(10.0).attitudeSigma(2)).isGreaterThan(0.3);
  }

  @Test
  void add_wheelsFallSilent_turnIsUncertainAgain() {
    start();
    drive(10.0, 0.01, 0.01);
    double before = estimate(10.0).attitudeSigma(2);
    assertThat(estimate(12.0).attitudeSigma(2)).isGreaterThan(before + 0.3);
  }
}
