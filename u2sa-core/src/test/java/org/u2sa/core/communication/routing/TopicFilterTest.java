package org.u2sa.core.communication.routing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TopicFilterTest {
  @ParameterizedTest
  @ValueSource(
      strings = {"a", "/", "//", "a/b", "#", "+", "a/#", "/#", "+/#", "+/+", "a/+/b", "$x"})
  void isValid_filters_true(String text) {
    assertThat(TopicFilter.isValid(text)).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "a\0b", "#/", "#/x", "a#", "a/#b", "##", "a/#/b", "+a", "a+", "a/+b/c", "++"})
  void isValid_others_false(String text) {
    assertThat(TopicFilter.isValid(text)).isFalse();
  }
}
