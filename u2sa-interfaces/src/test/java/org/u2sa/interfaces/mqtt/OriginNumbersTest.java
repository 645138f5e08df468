package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.schema.Origin;

/** How a sender numbers what it sends. */
class OriginNumbersTest {
  @Test
  void next_eachTopic_isNumberedFromOne() {
    OriginNumbers numbers = new OriginNumbers("me");

    assertThat(numbers.on("a").next()).isEqualTo(new Origin("me", 1));
    assertThat(numbers.on("a").next()).isEqualTo(new Origin("me", 2));
    assertThat(numbers.on("b").next()).isEqualTo(new Origin("me", 1));
  }

  @Test
  void on_sameTopic_isTheSameObject() {
    OriginNumbers numbers = OriginNumbers.ofNewSender();

    assertThat(numbers.on("a")).isSameAs(numbers.on("a"));
    assertThat(numbers.on("a")).isNotSameAs(numbers.on("b"));
  }

  @Test
  void ofNewSender_twice_areTwoSendersWithShortNames() {
    String one = OriginNumbers.ofNewSender().on("a").next().sender();
    String other = OriginNumbers.ofNewSender().on("a").next().sender();

    assertThat(one).hasSize(13).isNotEqualTo(other);
  }
}
