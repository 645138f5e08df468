package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A source's name as a level of a topic: one spelling for each name. */
class TopicSourceTest {
  @ParameterizedTest
  @CsvSource({
    "RUDDER, RUDDER",
    "a/b, a%002Fb",
    "a+b, a%002Bb",
    "a#b, a%0023b",
    "100%, 100%0025",
    "=Höhe 1, =Höhe 1"
  })
  void encode_anyName_isReadBackTheSame(String name, String level) {
    assertThat(Topic.sourceLevel(name)).isEqualTo(level);
    assertThat(Topic.sourceOf(level)).isEqualTo(name);
  }

  @Test
  void encode_controlCharacters_areEscaped() {
    assertThat(Topic.sourceLevel("\u0000\u001f \u007f\u009f\u00a0"))
        .isEqualTo("%0000%001F %007F%009F\u00a0");
  }

  @Test
  void decode_escapeCutShort_isRefused() {
    assertThatThrownBy(() -> Topic.sourceOf("a%002"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("source \"a%002\": expected four hexadecimal digits after '%'");
  }

  @Test
  void decode_escapeOfOtherThanHexadecimalDigits_isRefused() {
    assertThatThrownBy(() -> Topic.sourceOf("%00+F"))
        .hasMessage("source \"%00+F\": expected four hexadecimal digits after '%'");
  }

  @Test
  void decode_secondSpelling_isRefusedAndNamesTheFirst() {
    assertThatThrownBy(() -> Topic.sourceOf("a%002fb"))
        .hasMessage("source \"a%002fb\": expected \"a%002Fb\"");
    assertThatThrownBy(() -> Topic.sourceOf("%0041"))
        .hasMessage("source \"%0041\": expected \"A\"");
  }

  @Test
  void decode_empty_isRefused() {
    assertThatThrownBy(() -> Topic.sourceOf(""))
        .hasMessage("expected the source's name behind '='");
  }
}
