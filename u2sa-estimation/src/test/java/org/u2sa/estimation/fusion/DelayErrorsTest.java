package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A receiver that is later than it says, on a vehicle that starts, stops and turns. */
class DelayErrorsTest {
  private static final double SIGMA = 0.02;

  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final SimulatedMotion truth = new SimulatedMotion(5);
  private final Measurement m = new Measurement();
  private final Deque<double[]> underWay = new ArrayDeque<>();
  private double speed; // m/s
  private boolean isAhead;
  private boolean hasNoWheels; // but a receiver that measures its velocity
  private double worst; // error in claimed sigmas, since the start

  /** Drives a rectangle: 8 s at 1 m/s, 2 s for a turn of a right angle on the spot. */
  private void drive(double seconds, long lateMicros, boolean isStraight) {
    double psi = 0.0;
    for (long micros = 0; micros < seconds * 1e6; micros += 10_000L) {
      double phase = micros % 10_000_000L * 1e-6;
      boolean turns = !isStraight && phase >= 8.0;
      speed = turns ? 0.0 : isStraight ? 1.0 : Math.min(1.0, Math.min(phase, 8.0 - phase));
      speed = hasNoWheels ? Math.min(1.0, 0.3 * micros * 1e-6) : speed;
      psi += turns ? 0.01 * Math.PI / 4.0 : 0.0;
      truth.p[0] += 0.01 * speed * Math.cos(psi);
      truth.p[1] += 0.01 * speed * Math.sin(psi);
      long now = micros + 10_000L;
      underWay.add(new double[] {now + lateMicros, truth.p[0], truth.p[1]});
      if (now % 50_000L == 0) {
        double noisy = psi + truth.gauss(0.005);
        filter.add(
            m.begin("Compass", now).heading(Math.IEEEremainder(noisy, 6.28318530718), 0.005));
        if (!hasNoWheels) {
          filter.add(m.begin("Wheels", now).forward(speed + truth.gauss(0.01), 0.01));
        }
      }
      if (now % 100_000L == 0) {
        fix(now);
      }
      if (now > 1_000_000L) {
        look(now);
      }
    }
  }

  private void fix(long now) {
    while (underWay.size() > 1 && underWay.peek()[0] < now) {
      underWay.remove();
    }
    double[] then = underWay.peek();
    if (isAhead) {
      then = new double[] {now, 2.0 * truth.p[0] - then[1], 2.0 * truth.p[1] - then[2]};
    }
    Geodetic at =
        SimulatedMotion.HOME.fromNed(
            Point.of(then[1] + truth.gauss(SIGMA), then[2] + truth.gauss(SIGMA), 0.0));
    m.begin("GPS", now).place(at.latitudeDeg(), at.longitudeDeg(), SIGMA, SIGMA);
    if (hasNoWheels) {
      m.velocity(speed + truth.gauss(0.05), truth.gauss(0.05), 0.05); // straight to the north
    }
    filter.add(m);
  }

  private void look(long now) {
    Estimate e = filter.at(now);
    Geodetic said =
        new Geodetic(e.longitudeDeg(), e.latitudeDeg(), SimulatedMotion.HOME.altitudeM());
    Point ned = SimulatedMotion.HOME.nedOf(said);
    worst = Math.max(worst, Math.abs(ned.x() - truth.p[0]) / e.positionSigmaM(0));
    worst = Math.max(worst, Math.abs(ned.y() - truth.p[1]) / e.positionSigmaM(1));
  }

  private SourceReports.Report gps() {
    return filter.sources().at(truth.micros).stream()
        .filter(each -> each.source().equals("GPS"))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void add_laterThanItSaysByAFifth_isFoundOutAndSaid() {
    drive(60.0, 200_000L, false);
    assertThat(gps().lateS()).isBetween(0.17, 0.23);
    assertThat(gps().text()).contains("late by 0.");
    assertThat(worst).isLessThan(5.0);
  }

  @Test
  void add_asLateAsItSays_nothingIsSaid() {
    drive(60.0, 0L, false);
    assertThat(gps().lateS()).isZero();
    assertThat(worst).isLessThan(5.0);
  }

  /** Nothing tells how late it is: then the claim is as large as the delay may be. */
  @Test
  void add_straightAtConstantSpeed_positionAlongTheWayStaysUncertain() {
    drive(60.0, 100_000L, true);
    Estimate e = filter.at(60_000_000L);
    assertThat(e.positionSigmaM(0)).isBetween(0.05, 0.12);
    assertThat(e.positionSigmaM(1)).isLessThan(0.03);
  }

  /** The noise of the estimated velocity is no information on the delay. */
  @Test
  void add_longStraightByVelocitiesOfTheReceiver_errorStaysWithinItsClaim() {
    hasNoWheels = true;
    drive(300.0, 0L, true);
    assertThat(filter.at(300_000_000L).positionSigmaM(0)).isGreaterThan(0.03);
    assertThat(worst).isLessThan(3.5);
  }

  /** A receiver never measures ahead of time, whatever the positions look like. */
  @Test
  void add_fixesAheadOfTheVehicle_delayIsNotNegative() {
    isAhead = true;
    drive(60.0, 200_000L, false);
    assertThat(gps().lateS()).isZero();
  }
}
