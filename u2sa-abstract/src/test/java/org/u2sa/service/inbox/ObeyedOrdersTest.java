package org.u2sa.service.inbox;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.safety.ArmCommand;

class ObeyedOrdersTest {
  private static ArmCommand at(long micros) {
    ArmCommand command = untimed();
    command.timestamp(micros);
    return command;
  }

  private static ArmCommand untimed() {
    return new ArmCommand().requestId("id").arm(true).operator("Ann");
  }

  /** Two updates of goals, for example, may be published in the same microsecond. */
  @Test
  void add_otherContentWithTheSameIdAndTime_isNew() {
    ObeyedOrders orders = new ObeyedOrders();
    orders.add("", at(5));

    assertThat(orders.add("", at(5).operator("Bob"))).isTrue();
    assertThat(orders.add("", at(5))).isFalse();
  }

  @Test
  void add_sameIdAndTime_isNewOnce() {
    ObeyedOrders orders = new ObeyedOrders();

    assertThat(orders.add("1", at(5))).isTrue();
    assertThat(orders.add("1", at(5))).isFalse();
    assertThat(orders.add("1", at(6))).as("given again").isTrue();
    assertThat(orders.add("2", at(5))).isTrue();
    assertThat(orders.add("1", untimed())).isTrue();
    assertThat(orders.add("1", untimed())).isFalse();
    assertThat(orders.add("", at(5))).isTrue();
    assertThat(orders.add("", at(5))).isFalse();
  }

  @Test
  void add_withoutIdAndTime_isAlwaysNew() {
    ObeyedOrders orders = new ObeyedOrders();

    assertThat(orders.add("", untimed())).isTrue();
    assertThat(orders.add("", untimed())).isTrue();
  }

  @Test
  void takeOver_fromAPredecessor_knowsItsOrdersAndForgetsTheOldest() {
    ObeyedOrders before = new ObeyedOrders();
    for (int i = 0; i < 65; i++) {
      before.add("id", at(i));
    }
    ObeyedOrders after = new ObeyedOrders();
    after.takeOver(before.identities());

    assertThat(after.identities()).hasSize(64).isEqualTo(before.identities());
    assertThat(after.add("id", at(1))).isFalse();
    assertThat(after.add("id", at(64))).isFalse();
    assertThat(after.add("id", at(0))).isTrue();
  }
}
