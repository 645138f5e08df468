package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Vehicles that stand for 3 s and then accelerate by 2 m/s², such as a boat or an aeroplane on its
 * runway. Every sensor is as accurate as it claims.
 */
class HardStartTest {
  private static final double STEP_S = 0.01;
  private static final double STANDS_S = 3.0;
  private static final double MPS2 = 2.0;
  private static final double FROZEN_RATE_RAD_PER_S = 0.1;

  private final Measurement m = new Measurement();
  private final double[] truth = new double[4]; // north, east [m], heading [rad], speed [m/s]
  private ErrorStateFilter filter;
  private Random random;
  private double fixSigmaM;
  private double fixIntervalS;
  private double topMps;
  private boolean hasInertial = true;
  private boolean hasCompass = true;
  private boolean hasReceiverVelocity;
  private double frozenFromS = Double.POSITIVE_INFINITY;
  private double worstM;
  private double worstSigmas;

  private void start(MotionDomain domain, int seed) {
    filter = new ErrorStateFilter(FilterTuning.of(domain));
    random = new Random(seed);
    truth[2] = 0.7;
  }

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  private void move(double seconds) {
    for (int i = 1; i <= Math.round(seconds / STEP_S); i++) {
      double now = i * STEP_S;
      double forward = now < STANDS_S ? 0.0 : Math.min(MPS2, (topMps - truth[3]) / 0.5);
      double turn = truth[3] > 1.0 ? FROZEN_RATE_RAD_PER_S * Math.sin(0.3 * now) : 0.0;
      truth[2] += STEP_S * turn;
      truth[3] += STEP_S * forward;
      truth[0] += STEP_S * truth[3] * Math.cos(truth[2]);
      truth[1] += STEP_S * truth[3] * Math.sin(truth[2]);
      sense(Math.round(now * 1e6), i, forward, turn, now >= frozenFromS);
      if (now > 2.0 * STANDS_S && i % 10 == 0) {
        look(Math.round(now * 1e6));
      }
    }
  }

  private void sense(long micros, int step, double forward, double turn, boolean isFrozen) {
    if (hasInertial) {
      m.begin("IMU", micros);
      if (isFrozen) {
        m.bodyRates(0.001, 0.002, FROZEN_RATE_RAD_PER_S, 0.005).specificForce(0.0, 0.0, -9.8, 0.1);
      } else {
        m.bodyRates(noise(0.003), noise(0.003), turn + noise(0.003), 0.005)
            .specificForce(
                forward + noise(0.05), truth[3] * turn + noise(0.05), -9.7926 + noise(0.05), 0.1);
      }
      filter.add(m);
    }
    if (hasCompass && step % 10 == 0) {
      double psi = Math.IEEEremainder(truth[2] + noise(0.03), 2.0 * Math.PI);
      filter.add(m.begin("Compass", micros).heading(psi, 0.03));
    }
    if (step % Math.round(fixIntervalS / STEP_S) == 0) {
      Geodetic at =
          SimulatedMotion.HOME.fromNed(
              Point.of(truth[0] + noise(fixSigmaM), truth[1] + noise(fixSigmaM), 0.0));
      m.begin("GPS", micros).place(at.latitudeDeg(), at.longitudeDeg(), fixSigmaM, fixSigmaM);
      if (hasReceiverVelocity) {
        m.velocity(
            truth[3] * Math.cos(truth[2]) + noise(0.1),
            truth[3] * Math.sin(truth[2]) + noise(0.1),
            0.1);
      }
      filter.add(m);
    }
  }

  private void look(long micros) {
    Estimate e = filter.at(micros);
    Point ned = SimulatedMotion.HOME.nedOf(new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 10.0));
    double north = Math.abs(ned.x() - truth[0]);
    double east = Math.abs(ned.y() - truth[1]);
    worstM = Math.max(worstM, Math.hypot(north, east));
    worstSigmas = Math.max(worstSigmas, north / e.positionSigmaM(0));
    worstSigmas = Math.max(worstSigmas, east / e.positionSigmaM(1));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_takeOffRunWithoutCompass_accelerationIsNotTakenForTilt(int seed) {
    start(MotionDomain.AIR, seed);
    hasCompass = false;
    hasReceiverVelocity = true;
    fixSigmaM = 1.0;
    fixIntervalS = 1.0;
    topMps = 40.0;
    move(60.0);

    assertThat(worstM).isLessThan(4.0);
    assertThat(worstSigmas).isLessThan(4.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_preciseFixesWithWhiteNoise_neitherSpeedNorDelayIsReadIntoIt(int seed) {
    start(MotionDomain.WATER, seed);
    fixSigmaM = 0.02;
    fixIntervalS = 0.5;
    topMps = 15.0;
    move(60.0);

    assertThat(worstM).isLessThan(0.8);
    assertThat(worstSigmas).isLessThan(6.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_onlyPositionsOfAFastBoat_modelGivesWayBeforeTheReceiver(int seed) {
    start(MotionDomain.WATER, seed);
    hasInertial = false;
    fixSigmaM = 0.02;
    fixIntervalS = 0.5;
    topMps = 15.0;
    move(60.0);

    assertThat(worstM).isLessThan(4.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void add_frozenInertialSensor_staysOutUntilItsValuesChange(int seed) {
    start(MotionDomain.GROUND, seed);
    fixSigmaM = 0.5;
    fixIntervalS = 0.2;
    topMps = 5.0;
    frozenFromS = 30.0;
    move(90.0);

    double used = filter.trust().of(filter.state(), 0);
    assertThat(filter.state().trust[(int) used + SourceTrust.IS_FROZEN]).isEqualTo(1.0);
    assertThat(filter.state().isInertial).isFalse();
    assertThat(worstSigmas).isLessThan(4.0);
  }
}
