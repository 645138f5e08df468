package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TakeOffSequenceTest {
  private static final double ROTATION_MPS = 28.3;

  private static final TakeOffSequence.Variables VARIABLES =
      new TakeOffSequence.Variables(600.0, 1.0, 0.5, 55.0, 100.0);

  private final TakeOffSequence sequence = new TakeOffSequence(VARIABLES);
  private double timeS;

  @Test
  void step_wholeTakeOff_goesThroughAllPhases() {
    assertThat(step(States.standing(), true, 0.0)).isEqualTo(FlightPhase.RUN_UP);
    assertThat(step(States.standing(), true, 0.4)).isEqualTo(FlightPhase.RUN_UP);
    timeS += 1.0;
    assertThat(step(States.standing(), true, 0.6)).isEqualTo(FlightPhase.ROLL);
    assertThat(step(rolling(20.0), true, 1.0)).isEqualTo(FlightPhase.ROLL);
    assertThat(step(rolling(28.5), true, 1.0)).isEqualTo(FlightPhase.ROTATE);
    assertThat(step(rolling(30.0).onGround(false), true, 1.0)).isEqualTo(FlightPhase.ROTATE);
    timeS += 0.3;
    assertThat(step(rolling(31.0).onGround(false), true, 1.0)).isEqualTo(FlightPhase.CLIMB_OUT);
    assertThat(step(States.level().height(99.0), true, 1.0)).isEqualTo(FlightPhase.CLIMB_OUT);
    assertThat(step(States.level().height(100.0), true, 1.0)).isEqualTo(FlightPhase.CRUISE);
  }

  @Test
  void step_engineStarting_waits() {
    for (int i = 0; i < 200; i++) {
      assertThat(step(States.standing().starting(true), true, 0.6)).isEqualTo(FlightPhase.RUN_UP);
    }
    assertThat(sequence.cleared(States.standing().time(timeS).now())).isFalse();
  }

  @Test
  void step_noNavigation_neverRolls() {
    for (int i = 0; i < 200; i++) {
      assertThat(step(States.standing(), false, 0.6)).isEqualTo(FlightPhase.RUN_UP);
    }
  }

  @Test
  void step_navigationLostBeforeRotation_rejectsTheTakeOffForGood() {
    roll();
    assertThat(step(rolling(20.0), false, 1.0)).isEqualTo(FlightPhase.STOPPED);
    assertThat(step(rolling(10.0), true, 0.0)).isEqualTo(FlightPhase.STOPPED);
  }

  @Test
  void step_engineDiesBeforeRotation_rejectsTheTakeOff() {
    roll();
    assertThat(step(rolling(20.0).rpm(0.0), true, 1.0)).isEqualTo(FlightPhase.STOPPED);
  }

  @Test
  void step_airspeedStaysLow_rejectsTheTakeOff() {
    roll();
    assertThat(step(rolling(20.0).ground(34.0, 0.0), true, 1.0)).isEqualTo(FlightPhase.ROLL);
    assertThat(step(rolling(20.0).ground(36.0, 0.0), true, 1.0)).isEqualTo(FlightPhase.STOPPED);
  }

  @Test
  void step_navigationLostAfterRotation_climbsOutThenHolds() {
    roll();
    step(rolling(28.5), true, 1.0);
    step(rolling(30.0).onGround(false), false, 1.0);
    timeS += 1.0;
    assertThat(step(rolling(31.0).onGround(false), false, 1.0)).isEqualTo(FlightPhase.CLIMB_OUT);
    assertThat(step(States.level().height(100.0), false, 1.0)).isEqualTo(FlightPhase.HOLD);
    assertThat(step(States.level(), true, 1.0)).isEqualTo(FlightPhase.CRUISE);
  }

  @Test
  void step_firstSeenInTheAir_followsAtOnce() {
    assertThat(step(States.level(), true, 0.0)).isEqualTo(FlightPhase.CRUISE);
    assertThat(step(States.level(), false, 0.0)).isEqualTo(FlightPhase.HOLD);
  }

  @Test
  void step_firstSeenJustOffTheGround_goesOnClimbing() {
    assertThat(step(rolling(31.0).onGround(false), true, 1.0)).isEqualTo(FlightPhase.CLIMB_OUT);
  }

  @Test
  void step_firstSeenFastOnTheGround_takesOff() {
    assertThat(step(rolling(29.0), true, 1.0)).isEqualTo(FlightPhase.ROTATE);
  }

  @Test
  void step_firstSeenRollingSlowly_brakesAndBeginsAnew() {
    assertThat(step(rolling(20.0), true, 1.0)).isEqualTo(FlightPhase.RUN_UP);
  }

  @Test
  void step_firstSeenWhileItLands_landsOn() {
    FlightState flaring = rolling(31.0).onGround(false).time(timeS).now();
    assertThat(sequence.step(flaring, true, true, false, ROTATION_MPS, 0.0))
        .isEqualTo(FlightPhase.FLARE);
  }

  @Test
  void step_backOnTheGroundAndSlow_stops() {
    step(States.level(), true, 0.0);
    step(rolling(20.0), true, 0.5);
    timeS += 1.1;
    assertThat(step(rolling(19.0), true, 0.5)).isEqualTo(FlightPhase.STOPPED);
  }

  @Test
  void step_disarmed_neitherBeginsNorContinuesATakeOffRun() {
    sequence.armed(false);
    roll();
    assertThat(step(States.standing(), true, 0.6)).isEqualTo(FlightPhase.RUN_UP);

    sequence.armed(true);
    assertThat(step(States.standing(), true, 0.6)).isEqualTo(FlightPhase.ROLL);
    sequence.armed(false);
    assertThat(step(rolling(20.0), true, 1.0)).isEqualTo(FlightPhase.STOPPED);
  }

  @Test
  void step_disarmedAtRestAfterARun_mayTakeOffAgain() {
    roll();
    step(rolling(20.0), false, 1.0);
    step(States.standing(), true, 0.0);
    assertThat(step(States.standing(), true, 0.0)).isEqualTo(FlightPhase.STOPPED);

    sequence.armed(false);
    assertThat(step(rolling(2.0), true, 0.0)).isEqualTo(FlightPhase.STOPPED);
    assertThat(step(States.standing(), true, 0.0)).isEqualTo(FlightPhase.RUN_UP);
    sequence.armed(true);
    timeS += 1.0;
    assertThat(step(States.standing(), true, 0.6)).isEqualTo(FlightPhase.ROLL);
  }

  @Test
  void step_firstSeenRollingOutOrFlaringBeforeNavigation_landsOnOnceItArrives() {
    assertThat(step(rolling(20.0), false, 0.0)).isEqualTo(FlightPhase.RUN_UP);
    assertThat(land(rolling(20.0))).isEqualTo(FlightPhase.STOPPED);

    TakeOffSequence flaring = new TakeOffSequence(VARIABLES);
    FlightState state = rolling(31.0).onGround(false).time(timeS).now();
    assertThat(flaring.step(state, false, false, false, ROTATION_MPS, 0.0))
        .isEqualTo(FlightPhase.HOLD);
    assertThat(flaring.step(state, true, true, false, ROTATION_MPS, 0.0))
        .isEqualTo(FlightPhase.FLARE);
  }

  private FlightPhase land(States states) {
    timeS += 0.05;
    return sequence.step(states.time(timeS).now(), true, true, false, ROTATION_MPS, 0.0);
  }

  private void roll() {
    step(States.standing(), true, 0.0);
    timeS += 1.0;
    step(States.standing(), true, 0.6);
  }

  private static States rolling(double mps) {
    return States.standing().speed(mps).rpm(2400.0);
  }

  private FlightPhase step(States states, boolean navigating, double throttle) {
    timeS += 0.05;
    return sequence.step(
        states.time(timeS).now(), navigating, false, false, ROTATION_MPS, throttle);
  }
}
