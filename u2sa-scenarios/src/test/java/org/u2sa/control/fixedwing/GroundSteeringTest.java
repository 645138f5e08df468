package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class GroundSteeringTest {
  private static final double DT_S = 0.05;

  private final GroundSteering steering = new GroundSteering(TestTuning.standard().ground());

  GroundSteeringTest() {
    steering.lineUp(States.standing().now()); // heading east
  }

  @Test
  void offset_southOfALineToTheEast_isToTheRight() {
    assertThat(steering.offsetM(rolling().at(-3.0, 50.0).now())).isCloseTo(3.0, within(1e-9));
  }

  @Test
  void rudder_rightOfTheLine_isLeft() {
    assertThat(steering.rudder(rolling().at(-3.0, 50.0).now(), true, DT_S)).isNegative();
    assertThat(steering.rudder(rolling().at(3.0, 50.0).now(), true, DT_S)).isPositive();
  }

  @Test
  void rudder_noseRightOfTheLine_isLeft() {
    FlightState state = rolling().heading(Math.PI / 2.0 + 0.05).now();
    assertThat(steering.rudder(state, true, DT_S)).isNegative();
  }

  @Test
  void rudder_propellerPullsLeft_isHeldByTheIntegral() {
    FlightState pulled = rolling().rates(0.0, 0.0, -0.05).now();
    double first = steering.rudder(pulled, true, DT_S);
    double last = first;
    for (int i = 0; i < 40; i++) {
      last = steering.rudder(pulled, true, DT_S);
    }
    assertThat(first).isPositive();
    assertThat(last).isGreaterThan(first + 0.02);
  }

  @Test
  void rudder_windOnTheFinWithTheNoseUp_holdsAgainstIt() {
    FlightState fromTheLeft = rolling().beta(-0.2).now(); // would swing the nose left
    assertThat(steering.rudder(fromTheLeft, false, DT_S)).isPositive();
  }

  @Test
  void aileron_windFromTheRight_isRightAndLessWithSpeed() {
    double slow = steering.aileron(States.standing().speed(8.0).beta(Math.PI / 2).now());
    double fast = steering.aileron(States.standing().speed(25.0).beta(Math.asin(8.0 / 25.0)).now());
    assertThat(slow).isGreaterThan(fast);
    assertThat(fast).isPositive();
  }

  @Test
  void aheadPoint_onTheLine_liesStraightAhead() {
    FlightState state = rolling().at(0.0, 80.0).now();
    assertThat(steering.aheadEastM(state, 250.0)).isCloseTo(250.0, within(1e-9));
    assertThat(steering.aheadNorthM(state, 250.0)).isCloseTo(0.0, within(1e-9));
  }

  private static States rolling() {
    return States.standing().speed(15.0).rpm(2300.0);
  }
}
