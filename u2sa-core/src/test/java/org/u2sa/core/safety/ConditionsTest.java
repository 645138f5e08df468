package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.safety.WatchedVehicle.given;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.Condition;
import org.u2sa.service.handover.HandOver;

/** Which services have failed, as a successor knows it. */
class ConditionsTest {
  private static Conditions successor(Conditions before) {
    HandOver state = new HandOver("SafetyManager");
    before.handOver(state);
    Conditions successor = new Conditions();
    successor.takeOver(state);
    return successor;
  }

  @Test
  void takeOver_failedService_hasFailedUntilANewerConditionSaysOtherwise() {
    Conditions before = new Conditions();
    before.see(given("Motor", Condition.LOST));
    before.see(given("Rudder", Condition.DEAD).action("failsafe"));
    before.see(given("Camera", Condition.ALIVE));
    Conditions successor = successor(before);

    assertThat(successor.failure("Motor")).contains("service Motor is LOST: seen so");
    assertThat(successor.givenUp()).contains("service Rudder is DEAD: seen so");
    successor.see(given("Motor", Condition.ALIVE));
    assertThat(successor.failure("Motor")).isEmpty();
  }

  @Test
  void saved_failureOfAnotherService_changes() {
    Conditions conditions = new Conditions();
    conditions.see(given("Motor", Condition.LOST));
    String before = conditions.saved();
    conditions.see(given("Camera", Condition.ALIVE));
    assertThat(conditions.saved()).isEqualTo(before);
    conditions.see(given("Rudder", Condition.LOST));

    assertThat(conditions.saved()).isNotEqualTo(before);
  }
}
