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
 * A skid-steered rover drives straight and turns in place by half a circle, about a point behind
 * its reference point and to the side of it. Its wheels turn faster than it does.
 */
class TurnSlipTest {
  private static final double STEP_S = 0.01;
  private static final int STRAIGHT = 800; // steps
  private static final int TURN = 400;
  private static final double BEHIND_M = 0.15;
  private static final double ASIDE_M = 0.025;
  private static final double GRAVITY = 9.7926;

  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final Measurement m = new Measurement();
  private final double[] ne = new double[2]; // truth
  private final double[] neMps = new double[2];
  private double psi;
  private double speed;
  private Random random;
  private boolean hasInertial;
  private boolean hasWheels;
  private int looks;
  private int consistent;
  private double worstM;

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  @ParameterizedTest
  @CsvSource({
    "true, true, 1",
    "true, true, 2",
    "true, false, 3",
    "true, false, 4",
    "false, true, 5",
    "false, true, 6"
  })
  void add_turnsAboutAnotherPoint_estimateIsConsistentWithTheReceiver(
      boolean inertial, boolean wheels, int seed) {
    random = new Random(seed);
    hasInertial = inertial;
    hasWheels = wheels;
    for (int i = 1; i <= 6 * (STRAIGHT + TURN); i++) {
      int at = i % (STRAIGHT + TURN);
      double change = (at > 100 && at < STRAIGHT - 100 ? 0.8 : 0.0) - speed;
      double acceleration = Math.max(-1.0, Math.min(1.0, change / STEP_S));
      speed += STEP_S * acceleration;
      move(i, acceleration, at >= STRAIGHT ? Math.PI / (TURN * STEP_S) : 0.0);
    }

    assertThat(worstM).isLessThan(0.09);
    assertThat((double) consistent / looks).isGreaterThan(0.98);
  }

  private void move(int step, double acceleration, double turn) {
    psi += STEP_S * turn;
    double forward = speed - ASIDE_M * turn;
    double right = BEHIND_M * turn;
    neMps[0] = forward * Math.cos(psi) - right * Math.sin(psi);
    neMps[1] = forward * Math.sin(psi) + right * Math.cos(psi);
    ne[0] += STEP_S * neMps[0];
    ne[1] += STEP_S * neMps[1];
    sense(step, acceleration - right * turn, forward * turn, turn);
    if (step > 300 && step % 5 == 0) {
      look(step * 10_000L);
    }
  }

  private void sense(int step, double ahead, double aside, double turn) {
    long micros = step * 10_000L;
    if (hasInertial) {
      m.begin("IMU", micros)
          .bodyRates(noise(0.003), noise(0.003), turn + noise(0.003), 0.005)
          .specificForce(ahead + noise(0.05), aside + noise(0.05), -GRAVITY + noise(0.05), 0.1);
      filter.add(m);
    }
    if (step % 5 == 0) {
      if (hasWheels) {
        m.begin("Wheels", micros);
        m.set(SensedQuantity.BODY_VELOCITY, 0, speed, 0.012);
        m.set(SensedQuantity.BODY_VELOCITY, 1, 0.0, 0.017);
        m.set(SensedQuantity.EULER_RATES, 2, 1.8 * turn, 0.05);
        filter.add(m);
      }
      double heading = Math.IEEEremainder(psi + noise(0.0175), 2.0 * Math.PI);
      filter.add(m.begin("Compass", micros).heading(heading, 0.0175));
    }
    if (step % 10 == 0) {
      Geodetic at =
          SimulatedMotion.HOME.fromNed(Point.of(ne[0] + noise(0.02), ne[1] + noise(0.02), 0.0));
      m.begin("GPS", micros)
          .place(at.latitudeDeg(), at.longitudeDeg(), 0.02, 0.02)
          .altitude(at.altitudeM() + noise(0.03), 0.03)
          .velocity(neMps[0] + noise(0.1), neMps[1] + noise(0.1), noise(0.1), 0.3);
      filter.add(m);
    }
  }

  private void look(long micros) {
    Estimate e = filter.at(micros);
    Geodetic seen = new Geodetic(e.longitudeDeg(), e.latitudeDeg(), e.altitudeM());
    Point at = SimulatedMotion.HOME.nedOf(seen);
    double north = at.x() - ne[0];
    double east = at.y() - ne[1];
    looks++;
    boolean isWithin =
        Math.abs(north) < 3.0 * e.positionSigmaM(0) && Math.abs(east) < 3.0 * e.positionSigmaM(1);
    consistent += isWithin ? 1 : 0;
    worstM = Math.max(worstM, Math.hypot(north, east));
  }
}
