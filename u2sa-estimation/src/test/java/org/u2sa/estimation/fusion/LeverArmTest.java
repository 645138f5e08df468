package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** Sensors away from the reference point: a vehicle that turns on the spot does not move. */
class LeverArmTest {
  private static final Geodetic HOME = SimulatedMotion.HOME;
  private static final double TURN = 0.8; // rad/s, clockwise
  private static final double AHEAD = 1.0;
  private static final double RIGHT = 0.5;
  private static final double ABOVE = -0.4;

  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final Measurement m = new Measurement();
  private double farthestM;
  private double fastestMps;

  /** Turns on the spot for half a minute, after five seconds of rest. */
  private void turn(boolean hasImu, boolean isToldOf) {
    double before = 0.0;
    for (long micros = 0; micros <= 35_000_000L; micros += 10_000L) {
      double rate = micros < 5_000_000L ? 0.0 : TURN;
      double change = (rate - before) / 0.01;
      before = rate;
      double psi = rate * (micros - 5_000_000L) * 1e-6;
      if (hasImu) {
        m.begin("IMU", micros)
            .bodyRates(0.0, 0.0, rate, 1e-3)
            .specificForce(
                -rate * rate * AHEAD - change * RIGHT,
                -rate * rate * RIGHT + change * AHEAD,
                -9.80665,
                0.02);
        add(isToldOf);
      }
      if (micros % 50_000L == 0) {
        filter.add(m.begin("Compass", micros).heading(Math.IEEEremainder(psi, 6.283185307), 0.02));
      }
      if (micros % 100_000L == 0) {
        fix(micros, psi, rate);
        add(isToldOf);
        m.begin("DVL", micros).set(SensedQuantity.BODY_VELOCITY, 0, -rate * RIGHT, 0.02);
        m.set(SensedQuantity.BODY_VELOCITY, 1, rate * AHEAD, 0.02);
        add(isToldOf);
      }
      if (micros > 2_000_000L) {
        look(micros);
      }
    }
  }

  private void fix(long micros, double psi, double rate) {
    double north = AHEAD * Math.cos(psi) - RIGHT * Math.sin(psi);
    double east = AHEAD * Math.sin(psi) + RIGHT * Math.cos(psi);
    Geodetic antenna = HOME.fromNed(Point.of(north, east, ABOVE));
    m.begin("GPS", micros)
        .place(antenna.latitudeDeg(), antenna.longitudeDeg(), 0.02, 0.02)
        .altitude(antenna.altitudeM(), 0.05)
        .velocity(-rate * east, rate * north, 0.0, 0.05);
  }

  private void add(boolean isToldOf) {
    filter.add(isToldOf ? m.mounted(AHEAD, RIGHT, ABOVE) : m);
  }

  private void look(long micros) {
    Estimate e = filter.at(micros);
    Point apart = HOME.nedOf(new Geodetic(e.longitudeDeg(), e.latitudeDeg(), HOME.altitudeM()));
    farthestM = Math.max(farthestM, Math.hypot(apart.x(), apart.y()));
    fastestMps = Math.max(fastestMps, Math.hypot(e.velocityMps(0), e.velocityMps(1)));
  }

  @Test
  void add_turnsOnTheSpotWithImu_staysThere() {
    turn(true, true);
    assertThat(farthestM).isLessThan(0.03);
    assertThat(fastestMps).isLessThan(0.05);
    assertThat(filter.at(35_000_000L).altitudeM()).isCloseTo(HOME.altitudeM(), within(0.02));
  }

  @Test
  void add_turnsOnTheSpotWithoutImu_staysThere() {
    turn(false, true);
    assertThat(farthestM).isLessThan(0.1);
    assertThat(fastestMps).isLessThan(0.45); // until the compass has told of the turn
  }

  /** What the lever arm is for. */
  @Test
  void add_leverArmIsNotTold_circles() {
    turn(true, false);
    assertThat(farthestM).isGreaterThan(0.8);
  }
}
