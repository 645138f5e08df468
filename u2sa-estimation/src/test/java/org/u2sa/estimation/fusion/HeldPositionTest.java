package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A receiver that holds its position while the vehicle drives north at 0.8 m/s. */
class HeldPositionTest {
  private static final double SPEED_MPS = 0.8;
  private static final double SIGMA_M = 0.02;

  private final Random random = new Random(3);
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private long micros;
  private double worst;

  private void drive(double seconds, boolean isHeld, double heldNoise, double shownMps) {
    double held = SPEED_MPS * micros * 1e-6;
    for (int i = 1; i <= seconds * 20; i++) {
      micros += 50_000;
      double north = SPEED_MPS * micros * 1e-6;
      m.begin("Compass", micros).heading(0.01 * random.nextGaussian(), 0.01);
      filter.add(m);
      m.begin("Wheels", micros).forward(SPEED_MPS + 0.02 * random.nextGaussian(), 0.02);
      filter.add(m);
      if (i % 2 == 0) {
        double noise = isHeld ? heldNoise : SIGMA_M;
        double shown = (isHeld ? held : north) + noise * random.nextGaussian();
        Geodetic at = SimulatedMotion.HOME.fromNed(Point.of(shown, 0.0, 0.0));
        m.begin("GPS", micros)
            .place(at.latitudeDeg(), at.longitudeDeg(), SIGMA_M, SIGMA_M)
            .altitude(5.0 + 0.1 * random.nextGaussian(), 0.1)
            .velocity(isHeld ? shownMps : SPEED_MPS, 0.0, 0.3);
        filter.add(m);
      }
      worst = i == 1 ? worst : Math.max(worst, Math.abs(off(north))); // the first comes with i = 2
    }
  }

  private double off(double north) {
    Estimate e = filter.at(micros);
    Geodetic said = new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 0.0);
    return SimulatedMotion.HOME.nedOf(said).x() - north;
  }

  @Test
  void add_placeRepeatsWhileAltitudesGoOn_receiverIsFrozen() {
    drive(20.0, false, 0.0, 0.0);
    drive(30.0, true, 0.0, 0.0);
    assertThat(worst).isLessThan(0.3);
    assertThat(filter.sources().at(micros).toString()).contains("source=GPS, standing=FROZEN");
    drive(10.0, false, 0.0, 0.0);
    assertThat(filter.sources().at(micros).toString()).contains("source=GPS, standing=USED");
  }

  @Test
  void add_placeIsHeldWithNoiseButVelocityGoesOn_wheelsAreBelieved() {
    drive(20.0, false, 0.0, 0.0);
    drive(30.0, true, 0.003, SPEED_MPS);
    assertThat(worst).isLessThan(0.6);
    assertThat(filter.at(micros).velocityMps(0)).isBetween(0.7, 0.9);
  }
}
