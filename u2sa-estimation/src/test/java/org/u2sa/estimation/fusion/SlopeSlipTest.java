package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * A rover drives squares on a plane that rises to the north and turns in place at the corners. Its
 * tyres creep by a quarter of the slope along the way, an eighth across it, and more while they
 * skid.
 */
class SlopeSlipTest {
  private static final double STEP_S = 0.01;
  private static final double MPS = 0.8;
  private static final double SIDE_S = 12.0;
  private static final double CORNER_S = 3.0;
  private static final double GRAVITY = 9.7926;

  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final Measurement m = new Measurement();
  private final double[] ned = new double[3]; // truth
  private final double[] nedMps = new double[3];
  private double psi; // heading in the plane of the slope
  private double speed;
  private double acceleration;
  private Random random;
  private double slope; // tangent
  private int looks;
  private int consistent;
  private double worstM;

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  @ParameterizedTest
  @CsvSource({"0.0, 1", "0.1, 2", "0.15, 3", "0.15, 4", "0.3, 5"})
  void add_squaresOnASlope_estimateIsConsistentWithTheReceiver(double rise, int seed) {
    random = new Random(seed);
    slope = rise;
    int side = (int) Math.round(SIDE_S / STEP_S);
    int lap = side + (int) Math.round(CORNER_S / STEP_S);
    for (int i = 1; i <= 8 * lap; i++) {
      boolean isTurning = i % lap >= side;
      boolean isBraking = i % lap >= side - 1.0 / STEP_S;
      double change = (isBraking ? 0.0 : MPS) - speed;
      acceleration = Math.max(-1.0, Math.min(1.0, change / STEP_S));
      speed += STEP_S * acceleration;
      move(i, speed, isTurning ? Math.PI / 2.0 / CORNER_S : 0.0);
    }

    assertThat((double) consistent / looks).isGreaterThan(0.985);
    assertThat(worstM).isLessThan(0.12);
  }

  private void move(int step, double wheelMps, double turn) {
    psi += STEP_S * turn;
    double incline = Math.atan(slope);
    double ahead = Math.sin(incline) * Math.cos(psi); // sine of the pitch
    double abeam = Math.sin(incline) * Math.sin(psi);
    double skid = 0.1 * Math.abs(turn);
    double forward = wheelMps * (1.0 - 0.25 * ahead) - skid * ahead;
    double right = (wheelMps / 8.0 + skid) * abeam;
    nedMps[0] = (forward * Math.cos(psi) - right * Math.sin(psi)) * Math.cos(incline);
    nedMps[1] = forward * Math.sin(psi) + right * Math.cos(psi);
    nedMps[2] = -slope * nedMps[0];
    for (int i = 0; i < 3; i++) {
      ned[i] += STEP_S * nedMps[i];
    }
    sense(step, wheelMps, turn, ahead, abeam);
    if (step > 300 && step % 5 == 0) {
      look(step * 10_000L);
    }
  }

  private void sense(int step, double wheelMps, double turn, double ahead, double abeam) {
    long micros = step * 10_000L;
    double level = Math.sqrt(1.0 - ahead * ahead - abeam * abeam);
    m.begin("IMU", micros)
        .bodyRates(noise(0.003), noise(0.003), turn + noise(0.003), 0.005)
        .specificForce(
            GRAVITY * ahead + acceleration + noise(0.05),
            -GRAVITY * abeam + noise(0.05),
            -GRAVITY * level + noise(0.05),
            0.1);
    filter.add(m);
    if (step % 5 == 0) {
      m.begin("Wheels", micros);
      m.set(SensedQuantity.BODY_VELOCITY, 0, wheelMps, 0.0175);
      m.set(SensedQuantity.BODY_VELOCITY, 1, 0.0, 0.025);
      filter.add(m);
      double azimuth = Math.atan2(Math.sin(psi), Math.cos(psi) * Math.cos(Math.atan(slope)));
      double heading = Math.IEEEremainder(azimuth + noise(0.0175), 2.0 * Math.PI);
      filter.add(m.begin("Compass", micros).heading(heading, 0.0175));
    }
    if (step % 10 == 0) {
      Geodetic at =
          SimulatedMotion.HOME.fromNed(
              Point.of(ned[0] + noise(0.02), ned[1] + noise(0.02), ned[2] + noise(0.03)));
      m.begin("GPS", micros)
          .place(at.latitudeDeg(), at.longitudeDeg(), 0.02, 0.02)
          .altitude(at.altitudeM(), 0.03)
          .velocity(nedMps[0] + noise(0.1), nedMps[1] + noise(0.1), nedMps[2] + noise(0.1), 0.3);
      filter.add(m);
    }
  }

  private void look(long micros) {
    Estimate e = filter.at(micros);
    Geodetic seen = new Geodetic(e.longitudeDeg(), e.latitudeDeg(), e.altitudeM());
    Point at = SimulatedMotion.HOME.nedOf(seen);
    double[] error = {at.x() - ned[0], at.y() - ned[1], at.z() - ned[2]};
    boolean isWithin = true;
    for (int i = 0; i < 3; i++) {
      isWithin &= Math.abs(error[i]) < 3.0 * e.positionSigmaM(i);
    }
    looks++;
    consistent += isWithin ? 1 : 0;
    worstM = Math.max(worstM, Math.hypot(error[0], error[1]));
  }
}
