package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** An aircraft whose only receiver is later than it says, with all that it measures. */
class LateReceiverTest {
  private static final double SIGMA = 0.05; // m, m/s
  private static final double ANGLE_SIGMA = Math.toRadians(2.0);

  private final ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
  private final Measurement m = new Measurement();
  private final Deque<double[]> underWay = new ArrayDeque<>();
  private SimulatedMotion truth;
  private double fastest; // m/s, while it is late
  private double steepest; // likewise, vertically
  private double worst; // m, horizontally
  private double worstAltitude;
  private double worstHeading; // rad
  private double lastWorst; // m, of position and altitude in the last 20 s

  private void fly(int seed, double lateS, double fromS, double compassErrorRad, double seconds) {
    truth = new SimulatedMotion(seed);
    for (int i = 1; i <= seconds * 100.0; i++) {
      truth.fly(1.0, 0.1);
      double t = truth.micros * 1e-6;
      truth.imu(m, "IMU", new double[6], 0.003, 0.05);
      m.heading(truth.psi() + compassErrorRad + truth.gauss(ANGLE_SIGMA), ANGLE_SIGMA);
      double phi = Quaternions.phi(truth.r) + truth.gauss(ANGLE_SIGMA);
      double theta = Quaternions.theta(truth.r) + truth.gauss(ANGLE_SIGMA);
      m.set(SensedQuantity.TILT, 0, phi, ANGLE_SIGMA);
      m.set(SensedQuantity.TILT, 1, theta, ANGLE_SIGMA);
      filter.add(m);
      double[] p = truth.p;
      double[] v = truth.v;
      underWay.add(new double[] {p[0], p[1], p[2], v[0], v[1], v[2]});
      int late = t >= fromS ? (int) Math.round(lateS * 100.0) : 0;
      while (underWay.size() > late + 1) {
        underWay.remove();
      }
      if (i % 20 == 0) {
        filter.add(fix(underWay.peek()));
        look(t, seconds);
      }
    }
  }

  private Measurement fix(double[] then) {
    Geodetic at =
        SimulatedMotion.HOME.fromNed(
            Point.of(
                then[0] + truth.gauss(SIGMA),
                then[1] + truth.gauss(SIGMA),
                then[2] + truth.gauss(SIGMA)));
    return m.begin("GPS", truth.micros)
        .place(at.latitudeDeg(), at.longitudeDeg(), SIGMA, SIGMA)
        .altitude(at.altitudeM(), SIGMA)
        .velocity(
            then[3] + truth.gauss(SIGMA),
            then[4] + truth.gauss(SIGMA),
            then[5] + truth.gauss(SIGMA),
            SIGMA);
  }

  private void look(double t, double seconds) {
    Estimate e = filter.at(truth.micros);
    double[] errors = truth.errors(e);
    double apart = Math.hypot(errors[0], errors[1]);
    double above = Math.abs(e.altitudeM() - SimulatedMotion.HOME.altitudeM() + truth.p[2]);
    fastest = Math.max(fastest, Math.hypot(truth.v[0], truth.v[1]));
    steepest = Math.max(steepest, Math.abs(truth.v[2]));
    worst = Math.max(worst, apart);
    worstAltitude = Math.max(worstAltitude, above);
    worstHeading = Math.max(worstHeading, t > 1.0 ? Math.abs(errors[4]) : 0.0);
    lastWorst = Math.max(lastWorst, t > seconds - 20.0 ? Math.max(apart, above) : 0.0);
  }

  private SourceReports.Report report(String source) {
    return filter.sources().at(truth.micros).stream()
        .filter(each -> each.source().equals(source))
        .findFirst()
        .orElseThrow();
  }

  @ParameterizedTest
  @CsvSource({
    "100, 0.3, 0", "101, 0.5, 0", "102, 0.5, 0", "103, 0.5, 0", "104, 0.4, 0", "104, 0.5, 0",
    "100, 0.3, 20", "101, 0.5, 20", "102, 0.4, 20", "103, 0.5, 20", "104, 0.5, 20", "105, 0.5, 20"
  })
  void add_receiverLate_costsNoMoreThanTheWayOfThatTime(int seed, double lateS, double fromS) {
    fly(seed, lateS, fromS, 0.0, 60.0);
    assertThat(worst).isLessThan(0.5 + lateS * fastest);
    assertThat(worstAltitude).isLessThan(0.5 + lateS * steepest);
    assertThat(Math.toDegrees(worstHeading)).isLessThan(5.0);
    assertThat(lastWorst).isLessThan(0.4);
    assertThat(report("GPS").lateS()).isBetween(lateS - 0.05, lateS + 0.05);
    assertThat(report("IMU").standing()).isEqualTo(SourceReports.Standing.USED);
  }

  @ParameterizedTest
  @CsvSource({"100, 0", "101, 0", "102, 0", "100, 30", "101, -30", "102, 120"})
  void add_receiverInTime_isNotCalledLate(int seed, double compassErrorDeg) {
    fly(seed, 0.0, 0.0, Math.toRadians(compassErrorDeg), 60.0);
    assertThat(report("GPS").lateS()).isZero();
  }

  /** What a delay means is forgotten with it. */
  @Test
  void add_receiverNoLongerLate_isFollowedAgain() {
    fly(101, 0.5, 0.0, 0.0, 40.0);
    underWay.clear();
    for (int i = 1; i <= 4000; i++) {
      truth.fly(1.0, 0.1);
      truth.imu(m, "IMU", new double[6], 0.003, 0.05);
      m.heading(truth.psi() + truth.gauss(ANGLE_SIGMA), ANGLE_SIGMA);
      filter.add(m);
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", SIGMA, SIGMA, 1.0));
      }
    }
    lastWorst = 0.0;
    look(100.0, 100.0);
    assertThat(lastWorst).isLessThan(0.4);
    assertThat(report("GPS").lateS()).isZero();
  }
}
