package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/** Wind, wheel-speed scale, inertial sensors that come and go, and the start without a compass. */
class OptionalStatesTest {
  private final SimulatedMotion truth = new SimulatedMotion(5);
  private final Measurement m = new Measurement();

  /** Circles at a speed through the fluid or over ground, drifting with a flow. */
  private void circle(double speed, double radPerS, double flowNorth, double flowEast) {
    double dt = SimulatedMotion.STEP_MICROS * 1e-6;
    truth.rate[2] = radPerS;
    Quaternions.turnBody(truth.q, 0, 0.0, 0.0, radPerS * dt);
    truth.v[0] = speed * Math.cos(truth.psi()) + flowNorth;
    truth.v[1] = speed * Math.sin(truth.psi()) + flowEast;
    truth.p[0] += dt * truth.v[0];
    truth.p[1] += dt * truth.v[1];
    truth.micros += SimulatedMotion.STEP_MICROS;
  }

  @Test
  void add_airspeedInWind_findsTheWind() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
    for (int i = 1; i <= 12000; i++) {
      circle(20.0, 0.1, 3.0, -4.0);
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 1.0, 0.2, 1.0));
        filter.add(truth.compass(m, "Compass", 0.03));
        m.begin("Pitot", truth.micros).forwardThroughFluid(20.0 + truth.gauss(0.5), 0.5);
        filter.add(m);
      }
    }
    Estimate e = filter.at(truth.micros);
    assertThat(e.hasFlow()).isTrue();
    assertThat(e.flowMps(0)).isCloseTo(3.0, within(3.0 * e.flowSigmaMps(0)));
    assertThat(e.flowMps(1)).isCloseTo(-4.0, within(3.0 * e.flowSigmaMps(1)));
    assertThat(e.flowSigmaMps(0)).isLessThan(1.0);
  }

  @Test
  void add_wheelsThatCountTooMuch_findsTheScale() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
    for (int i = 1; i <= 12000; i++) {
      circle(2.0, 0.1, 0.0, 0.0);
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.05, 0.05, 1.0));
        filter.add(truth.compass(m, "Compass", 0.03));
      }
      if (i % 5 == 0) {
        m.begin("Wheels", truth.micros).forward(1.04 * 2.0 + truth.gauss(0.02), 0.02);
        filter.add(m);
      }
    }
    assertThat(filter.at(truth.micros).wheelScale()).isCloseTo(0.04, within(0.01));
  }

  /** A submarine sails sideways: its log measures the drift that the constraint denies. */
  @Test
  void add_logMeasuresTheDrift_noSlipIsNotSupposed() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.UNDERWATER));
    double sum = 0.0;
    for (int i = 1; i <= 6_000; i++) {
      long micros = i * 100_000L;
      filter.add(m.begin("Compass", micros).heading(truth.gauss(0.01), 0.01));
      if (i % 10 == 0) {
        m.begin("Log", micros);
        m.set(SensedQuantity.BODY_VELOCITY, 1, 0.5 + truth.gauss(0.05), 0.05);
        m.set(SensedQuantity.FLUID_VELOCITY, 0, truth.gauss(0.05), 0.05);
        m.set(SensedQuantity.FLUID_VELOCITY, 1, 0.5 + truth.gauss(0.05), 0.05);
        filter.add(m);
      }
      sum += filter.at(micros).velocityMps(1);
    }
    assertThat(filter.at(600_000_000L).hasFlow()).isTrue();
    assertThat(sum / 6_000).isCloseTo(0.5, within(0.02));
  }

  @Test
  void add_withoutCompass_directionOfMotionBecomesTheHeading() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
    for (int i = 1; i <= 3000; i++) {
      circle(2.0, 0.05, 0.0, 0.0);
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.1, 1.0));
      }
      if (i == 100) {
        assertThat(filter.at(truth.micros).hasHeading()).isFalse();
      }
    }
    Estimate e = filter.at(truth.micros);
    assertThat(e.hasHeading()).isTrue();
    assertThat(Math.IEEEremainder(e.psi() - truth.psi(), 2.0 * Math.PI))
        .isCloseTo(0.0, within(0.15));
  }

  @Test
  void add_inertialSensorComesAndGoes_estimateGoesOn() {
    ErrorStateFilter filter = new ErrorStateFilter(Tunings.withoutConstraint(MotionDomain.AIR));
    double[] bias = truth.biases(0.005, 0.05);
    double worst = 0.0;
    for (int i = 1; i <= 9000; i++) {
      truth.fly(i < 200 ? 0.0 : 1.0, i < 200 ? 0.0 : 0.1);
      boolean hasImu = i < 3000 || i > 6000;
      if (hasImu) {
        filter.add(truth.imu(m, "IMU", bias, 0.01, 0.2));
      }
      if (i % 20 == 0) {
        filter.add(truth.fix(m, "GPS", 0.5, 0.2, 1.0));
        filter.add(truth.compass(m, "Compass", 0.03));
      }
      if (i > 500) {
        double[] e = truth.errors(filter.at(truth.micros));
        worst = Math.max(worst, Math.hypot(e[0], e[1]));
      }
      if (i == 5999) {
        assertThat(filter.at(truth.micros).isStrapdown()).isFalse();
      }
    }
    assertThat(filter.at(truth.micros).isStrapdown()).isTrue();
    assertThat(worst).isLessThan(3.0);
  }

  @Test
  void add_inertialSensorAlone_staysLevel() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
    for (int i = 1; i <= 6000; i++) {
      truth.fly(0.1, 0.05);
      filter.add(truth.imu(m, "IMU", new double[6], 0.01, 0.2));
    }
    Estimate e = filter.at(truth.micros);
    Quaternions.matrix(truth.q, 0, truth.r);
    assertThat(e.hasPosition()).isFalse();
    assertThat(e.phi()).isCloseTo(Quaternions.phi(truth.r), within(0.06));
    assertThat(e.theta()).isCloseTo(Quaternions.theta(truth.r), within(0.06));
  }

  @Test
  void add_acrossTheDateLine_positionWraps() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.WATER));
    double longitude = 179.9999;
    for (int i = 1; i <= 200; i++) {
      longitude += 1e-6;
      m.begin("GPS", i * 100_000L)
          .place(-17.0, longitude > 180.0 ? longitude - 360.0 : longitude, 1.0, 1.0);
      filter.add(m);
    }
    assertThat(filter.at(20_000_000L).longitudeDeg()).isCloseTo(-179.9999, within(2e-5));
  }

  /** Simulated time begins at 0: a first fix at that time is one. */
  @Test
  void add_takeOffAfterOneFixAtTimeZero_velocityFollowsTheSpecificForce() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
    filter.add(truth.fix(m, "GPS", 0.05, 0.05, 1.0));
    m.begin("Compass", 0L).heading(0.0, 0.01);
    m.set(SensedQuantity.TILT, 0, 0.0, 0.01);
    m.set(SensedQuantity.TILT, 1, 0.0, 0.01);
    filter.add(m);
    for (long micros = 20_000L; micros <= 900_000L; micros += 20_000L) {
      m.begin("IMU", micros).bodyRates(0.0, 0.0, 0.0, 0.001);
      filter.add(m.specificForce(0.0, 0.0, -13.8, 0.05)); // 4 m/s² upward
    }
    assertThat(filter.at(900_000L).velocityMps(2)).isCloseTo(-3.5, within(0.5));
  }
}
