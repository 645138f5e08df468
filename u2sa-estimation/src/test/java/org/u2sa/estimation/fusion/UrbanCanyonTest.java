package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * A car between tall buildings, without a compass: its receiver takes reflections for signals, so
 * that its positions are off by twice what it claims, for half a minute, and jump as a signal comes
 * or goes. Good wheels and a good gyroscope.
 */
class UrbanCanyonTest {
  private static final double CLAIM_M = 10.0;
  private static final double TRUE_SIGMA_M = 15.0;
  private static final double PERSISTS_S = 20.0;
  private static final double JUMPS_PER_S = 0.05;
  private static final double JUMP_M = 20.0;
  private static final double SETTLED_S = 10.0;
  private static final int SEEDS = 6;

  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final Measurement m = new Measurement();
  private double psi = 2.0;
  private double north;
  private double east;
  private double foundS;
  private double firstHeadingOff;
  private double judged;
  private double within;
  private double headingWithin;
  private double squares;

  /** Streets of 10 s at 6 m/s with a right-angled corner after each, left and right at random. */
  private void drive(double seconds, Random random) {
    double[] error = {TRUE_SIGMA_M * random.nextGaussian(), TRUE_SIGMA_M * random.nextGaussian()};
    double kept = Math.exp(-0.2 / PERSISTS_S);
    double turn = 0.0;
    for (int i = 1; i <= seconds * 5.0; i++) {
      int phase = i % 70;
      turn = phase != 50 ? turn : random.nextBoolean() ? 0.4 : -0.4;
      double rate = phase >= 50 ? turn : 0.0;
      psi += 0.2 * rate;
      north += 0.2 * 6.0 * Math.cos(psi);
      east += 0.2 * 6.0 * Math.sin(psi);
      long micros = i * 200_000L;
      m.begin("Wheels", micros).forward(6.0 + 0.05 * random.nextGaussian(), 0.05);
      filter.add(m.turnRate(rate + 0.002 * random.nextGaussian(), 0.002));
      for (int axis = 0; axis < 2; axis++) {
        double fresh = TRUE_SIGMA_M * Math.sqrt(1.0 - kept * kept);
        double jump = random.nextDouble() < 0.2 * JUMPS_PER_S ? JUMP_M : 0.0;
        error[axis] = kept * error[axis] + (fresh + jump) * random.nextGaussian();
      }
      Geodetic at = SimulatedMotion.HOME.fromNed(Point.of(north + error[0], east + error[1], 0.0));
      m.begin("GPS", micros).place(at.latitudeDeg(), at.longitudeDeg(), CLAIM_M, CLAIM_M);
      filter.add(m);
      look(0.2 * i, micros);
    }
  }

  private void look(double seconds, long micros) {
    Estimate e = filter.at(micros);
    if (!e.hasHeading()) {
      return;
    }
    double headingOff = Math.abs(Math.IEEEremainder(e.psi() - psi, 2.0 * Math.PI));
    if (foundS == 0.0) {
      foundS = seconds;
      firstHeadingOff = headingOff / e.attitudeSigma(2);
    }
    if (seconds < foundS + SETTLED_S) {
      return;
    }
    Geodetic said =
        new Geodetic(e.longitudeDeg(), e.latitudeDeg(), SimulatedMotion.HOME.altitudeM());
    Point ned = SimulatedMotion.HOME.nedOf(said);
    double off = Math.hypot(ned.x() - north, ned.y() - east);
    judged++;
    squares += off * off;
    within += off < 3.0 * Math.hypot(e.positionSigmaM(0), e.positionSigmaM(1)) ? 1.0 : 0.0;
    headingWithin += headingOff < 3.0 * e.attitudeSigma(2) ? 1.0 : 0.0;
  }

  @Test
  void add_reflectionsForSignals_claimsHoldAndWheelsAreBelieved() {
    double sum = 0.0;
    for (int seed = 1; seed <= SEEDS; seed++) {
      UrbanCanyonTest course = new UrbanCanyonTest();
      course.drive(300.0, new Random(seed));
      assertThat(course.firstHeadingOff).isLessThan(3.0);
      assertThat(course.within / course.judged).isGreaterThan(0.9);
      assertThat(course.headingWithin / course.judged).isGreaterThan(0.9);
      sum += Math.sqrt(course.squares / course.judged);
    }
    assertThat(sum / SEEDS).isLessThan(20.0);
  }
}
