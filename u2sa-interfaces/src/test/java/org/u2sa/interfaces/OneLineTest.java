package org.u2sa.interfaces;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What of a foreign text reaches a line of a log or terminal. */
class OneLineTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "\n", "\r\n", "\u0085", "\u2028", "\u2029", "\u001b", "\u0000", "\u007f", "\u009b",
        "\u200e", "\u200f", "\u202a", "\u202e", "\u2066", "\u2069", "\u061c", "\u200b", "\u200d",
        "\u2060", "\ufeff", "\u00ad", "\u034f", "\u3164", "\uffa0", "\udb40\udc41"
      })
  void of_characterThatEndsALineOrCannotBeSeen_isASpace(String character) {
    assertThat(OneLine.of("a" + character + character + "b")).isEqualTo("a b");
  }

  @Test
  void of_textOfAnyScript_stays() {
    String text = "\tGrüße, 東京, \u05e9\u05dc\u05d5\u05dd, \ud83d\udea8 50 °C";
    assertThat(OneLine.of(text)).isEqualTo(text);
  }
}
