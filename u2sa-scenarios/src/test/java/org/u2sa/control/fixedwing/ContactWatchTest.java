package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** An aeroplane without sensors on its wheels that is on the ground although it seems higher. */
class ContactWatchTest {
  private static final double STEP_S = 0.02;

  private final Autopilot autopilot = new Autopilot(TestTuning.standard());
  private final Random noise = new Random(7);
  private Surfaces surfaces;
  private double timeS;
  private double heightM = 40.0;
  private double speedMps = 38.0;
  private double eastM;

  /** Along a descent to the east that it follows, except on the ground, which is at a height. */
  private void fly(double forS, double groundM, double noiseMps, boolean sensed) {
    for (double s = 0.0; s < forS; s += STEP_S) {
      timeS += STEP_S;
      eastM += speedMps * STEP_S;
      double sinkMps = heightM > groundM ? 2.0 : 0.0;
      heightM -= sinkMps * STEP_S;
      double path = Math.max(0.0, 34.0 - 2.0 * timeS);
      States seen =
          States.level()
              .time(timeS)
              .at(0.0, eastM)
              .altitude(heightM)
              .height(heightM)
              .speed(speedMps)
              .climb(-sinkMps + noiseMps * noise.nextGaussian())
              .wheelsSensed(sensed);
      surfaces =
          autopilot.step(
              seen.now(),
              Optional.of(new GuidanceTarget(0.0, 150.0, path, OptionalDouble.empty())));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 0.15})
  void step_descentEndsOnTheGroundAboveTheFlare_closesThrottleAndBrakes(double noiseMps) {
    fly(13.0, 13.5, noiseMps, false);
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.CRUISE);
    fly(4.0, 13.5, noiseMps, false);
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.FLARE);
    speedMps = 25.0;
    fly(4.0, 13.5, noiseMps, false);

    assertThat(autopilot.phase()).isEqualTo(FlightPhase.STOPPED);
    assertThat(surfaces.throttle()).isZero();
    assertThat(surfaces.brakes()).isPositive();
    assertThat(Math.abs(surfaces.aileron())).isLessThan(0.05);
  }

  @Test
  void step_descentIsFollowed_flaresAtItsHeightOnly() {
    fly(14.0, 0.0, 0.3, false);
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.CRUISE);
    fly(3.0, 0.0, 0.3, false);
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.FLARE);
    assertThat(heightM).isGreaterThan(4.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0, 2.0, 3.0})
  void step_gustsHoldItUp_isNotTakenForTheGround(double gustMps) {
    TouchDown.ContactWatch watch = new TouchDown.ContactWatch();
    for (double s = 0.0; s < 60.0; s += STEP_S) {
      double climb = -1.5 + gustMps * Math.sin(2.0 * Math.PI * s / 8.0);
      FlightState seen = States.level().height(10.0).climb(climb).wheelsSensed(false).now();
      watch.step(seen, FlightPhase.CRUISE, 1.5, STEP_S);
      assertThat(watch.isHindered()).as("at %.1f s", s).isFalse();
    }
  }

  @Test
  void step_weightOnWheelsIsSensed_believesTheSensor() {
    fly(20.0, 13.5, 0.0, true);
    assertThat(autopilot.phase()).isEqualTo(FlightPhase.CRUISE);
  }

  @Test
  void step_gustsHoldItUpForASecond_flaresAtItsHeightOnly() {
    for (double high = 14.0; high > 10.0; high -= 1.0) {
      fly(1.3, high, 0.3, false);
      fly(0.6, 0.0, 0.3, false);
      assertThat(autopilot.phase()).isEqualTo(FlightPhase.CRUISE);
    }
  }
}
