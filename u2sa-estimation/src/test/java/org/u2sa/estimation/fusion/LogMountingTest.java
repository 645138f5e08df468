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
 * A submarine that runs around a square at the surface and then under water, without a receiver;
 * its velocity log has a wrong scale or is mounted askew.
 */
class LogMountingTest {
  private static final double SPEED_MPS = 0.5;
  private static final double LEG_S = 40.0;
  private static final double TURN_S = 12.0;

  private final Random random = new Random(7);
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.UNDERWATER));
  private double north;
  private double east;
  private double scale;
  private double yawRad;
  private double worstM;
  private double worstSigmas;

  private double gauss(double sigma) {
    return sigma * random.nextGaussian();
  }

  private void run(double fromS, double untilS, boolean isAfloat) {
    for (long i = Math.round(5.0 * fromS) + 1; i <= Math.round(5.0 * untilS); i++) {
      long micros = i * 200_000L;
      double legs = 0.2 * i / LEG_S;
      double turn = Math.min(1.0, (legs - (int) legs) * LEG_S / TURN_S);
      double psi = Math.PI / 2.0 * ((int) legs - 1.0 + turn);
      north += 0.2 * SPEED_MPS * Math.cos(psi);
      east += 0.2 * SPEED_MPS * Math.sin(psi);
      if (isAfloat) {
        Geodetic at = SimulatedMotion.HOME.fromNed(Point.of(north + gauss(0.05), east, 0.0));
        m.begin("GPS", micros).place(at.latitudeDeg(), at.longitudeDeg(), 0.1, 0.1);
        filter.add(
            m.velocity(
                SPEED_MPS * Math.cos(psi) + gauss(0.05),
                SPEED_MPS * Math.sin(psi) + gauss(0.05),
                0.05));
      }
      filter.add(m.begin("Compass", micros).heading(psi + gauss(0.005), 0.01));
      m.begin("Log", micros);
      double forward = scale * SPEED_MPS * Math.cos(yawRad) + gauss(0.01);
      double right = -scale * SPEED_MPS * Math.sin(yawRad) + gauss(0.01);
      m.set(SensedQuantity.BODY_VELOCITY, 0, forward, 0.01);
      m.set(SensedQuantity.BODY_VELOCITY, 1, right, 0.01);
      filter.add(m);
      Estimate e = filter.at(micros);
      Geodetic said = new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 0.0);
      Point ned = SimulatedMotion.HOME.nedOf(said);
      if (!isAfloat) {
        worstM = Math.max(worstM, Math.hypot(ned.x() - north, ned.y() - east));
        worstSigmas = Math.max(worstSigmas, Math.abs(ned.x() - north) / e.positionSigmaM(0));
        worstSigmas = Math.max(worstSigmas, Math.abs(ned.y() - east) / e.positionSigmaM(1));
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"1.0, 0.0", "1.05, 0.0", "0.95, 0.0", "1.0, 5.0", "1.0, -5.0", "1.03, 3.0"})
  void add_receiverAtTheSurface_errorIsLearnedForTheDive(double times, double deg) {
    scale = times;
    yawRad = Math.toRadians(deg);
    run(0.0, 4.0 * LEG_S, true);
    run(4.0 * LEG_S, 12.0 * LEG_S, false);
    assertThat(worstM).isLessThan(1.0);
    assertThat(worstSigmas).isLessThan(3.0);
  }

  @ParameterizedTest
  @CsvSource({"1.05, 0.0", "0.95, 0.0", "1.0, 5.0", "1.0, -5.0"})
  void add_noReceiverUnderWay_sigmaCoversTheError(double times, double deg) {
    scale = times;
    yawRad = Math.toRadians(deg);
    Geodetic home = SimulatedMotion.HOME;
    filter.add(m.begin("GPS", 0L).place(home.latitudeDeg(), home.longitudeDeg(), 0.1, 0.1));
    run(0.0, 2.0 * LEG_S, false);
    assertThat(worstSigmas).isLessThan(3.0);
  }
}
