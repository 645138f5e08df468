package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Point;

class StanleyLawTest {
  private static final double WHEELBASE_M = 0.6;
  private static final double STEP_S = 0.001;

  /**
   * Small errors of the front axle decay as e^(−k t), whatever the speed (Hoffmann et al. 2007,
   * equation 9); a bicycle without slip along a line to the north.
   */
  @ParameterizedTest
  @CsvSource({"1.0, 2.0", "2.0, 3.0", "0.5, 5.0"})
  void steeringRad_smallErrorWithoutSoftening_decaysExponentially(double k, double speed) {
    StanleyLaw.Variables tuning = new StanleyLaw.Variables(k, 0.0, 0.0);
    double right = 0.05; // of the path, front axle
    double heading = 0.0;
    double decayed = Double.NaN;
    double started = Double.NaN;
    for (double t = 0.0; t < 3.0 / k; t += STEP_S) {
      double steering = StanleyLaw.steeringRad(tuning, heading, right, speed, 0.0);
      // the front axle moves where its wheels point; heading clockwise, steering to the left
      right += STEP_S * speed * Math.sin(heading - steering);
      heading -= STEP_S * speed * Math.sin(steering) / WHEELBASE_M;
      started = Double.isNaN(started) && t >= 1.0 / k ? right : started;
      decayed = t < 2.0 / k ? right : decayed;
    }

    assertThat(decayed / started).isCloseTo(Math.exp(-1.0), within(0.02));
  }

  @Test
  void steeringRad_farFromThePath_headsStraightToIt() {
    StanleyLaw.Variables tuning = new StanleyLaw.Variables(2.0, 0.0, 0.0);

    assertThat(StanleyLaw.steeringRad(tuning, 0.0, 1000.0, 1.0, 0.0))
        .isCloseTo(Math.PI / 2.0, within(0.01));
  }

  @Test
  void steeringRad_yawRateBeyondThePaths_steersAgainst() {
    StanleyLaw.Variables tuning = new StanleyLaw.Variables(2.0, 0.0, 0.1);

    assertThat(StanleyLaw.steeringRad(tuning, 0.0, 0.0, 1.0, 0.5)).isCloseTo(-0.05, within(1e-9));
  }

  @Test
  void trail_pointAheadOfTheVehicle_drawsThePath() {
    TargetTrail trail = new TargetTrail();
    for (double north = 2.0; north < 10.0; north += 0.25) {
      trail.see(Point.of(north, 1.0, 0.0), Point.of(north - 2.0, 1.5, 0.0));
    }

    TargetTrail.Beside beside = trail.beside(Point.of(6.0, 1.5, 0.0)).orElseThrow();

    assertThat(beside.rightM()).isCloseTo(0.5, within(1e-9));
    assertThat(beside.headingRad()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void trail_nextWaypoint_isTheLegFromTheOneBefore() {
    TargetTrail trail = new TargetTrail();
    trail.see(Point.of(10.0, 0.0, 0.0), Point.ORIGIN);
    trail.see(Point.of(10.0, 10.0, 0.0), Point.of(9.5, 0.0, 0.0));

    TargetTrail.Beside beside = trail.beside(Point.of(9.0, 4.0, 0.0)).orElseThrow();

    assertThat(beside.rightM()).isCloseTo(1.0, within(1e-9)); // to the east, the south is right
    assertThat(beside.headingRad()).isCloseTo(Math.PI / 2.0, within(1e-9));
    assertThat(new TargetTrail().beside(Point.ORIGIN)).isEmpty();
  }
}
