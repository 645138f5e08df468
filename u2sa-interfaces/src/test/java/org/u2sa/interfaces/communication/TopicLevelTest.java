package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A name as a level of a topic: one spelling for each name. */
class TopicLevelTest {
  @ParameterizedTest
  @CsvSource({
    "RUDDER, RUDDER",
    "a/b, a%002Fb",
    "a+b, a%002Bb",
    "a#b, a%0023b",
    "100%, 100%0025",
    "=Höhe 1, =Höhe%00201",
    "LEFT WHEEL, LEFT%0020WHEEL",
    "GPS.front, GPS%002Efront",
    "a*b, a%002Ab",
    "a>b, a%003Eb"
  })
  void of_anyName_isReadBackTheSame(String name, String level) {
    assertThat(TopicLevel.of(name)).isEqualTo(level);
    assertThat(TopicLevel.name(level)).isEqualTo(name);
  }

  @Test
  void of_controlCharacters_areEscaped() {
    assertThat(TopicLevel.of("\u0000\u001f \u007f\u009f\u00a0"))
        .isEqualTo("%0000%001F%0020%007F%009F\u00a0");
  }

  @Test
  void name_writtenBeforeFormat3_isReadToo() {
    assertThat(TopicLevel.name("LEFT WHEEL")).isEqualTo("LEFT WHEEL");
    assertThat(TopicLevel.name("1.5 > *%0025")).isEqualTo("1.5 > *%");
  }

  @Test
  void name_halfAsBeforeFormat3_isRefused() {
    assertThatThrownBy(() -> TopicLevel.name("a b%0020c"))
        .hasMessage("source \"a b%0020c\": expected \"a%0020b%0020c\"");
  }

  @Test
  void name_escapeCutShort_isRefused() {
    assertThatThrownBy(() -> TopicLevel.name("a%002"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("source \"a%002\": expected four hexadecimal digits after '%'");
  }

  @Test
  void name_escapeOfOtherThanHexadecimalDigits_isRefused() {
    assertThatThrownBy(() -> TopicLevel.name("%00+F"))
        .hasMessage("source \"%00+F\": expected four hexadecimal digits after '%'");
  }

  @Test
  void name_secondSpelling_isRefusedAndNamesTheFirst() {
    assertThatThrownBy(() -> TopicLevel.name("a%002fb"))
        .hasMessage("source \"a%002fb\": expected \"a%002Fb\"");
    assertThatThrownBy(() -> TopicLevel.name("%0041"))
        .hasMessage("source \"%0041\": expected \"A\"");
    assertThatThrownBy(() -> TopicLevel.name("a#"))
        .hasMessage("source \"a#\": expected \"a%0023\"");
  }

  @Test
  void name_empty_isRefused() {
    assertThatThrownBy(() -> TopicLevel.name(""))
        .hasMessage("expected the source's name behind '='");
  }
}
