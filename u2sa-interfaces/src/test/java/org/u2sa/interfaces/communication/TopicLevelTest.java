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

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          ''        | expected the source's name after '='
          a b%0020c | source "a b%0020c": expected "a%0020b%0020c"
          a%002     | source "a%002": expected four hexadecimal digits after '%'
          %00+F     | source "%00+F": expected four hexadecimal digits after '%'
          a%002fb   | source "a%002fb": expected "a%002Fb"
          %0041     | source "%0041": expected "A"
          a#        | source "a#": expected "a%0023"
          """)
  void name_otherSpelling_isRefused(String level, String message) {
    assertThatThrownBy(() -> TopicLevel.name(level))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(message);
  }
}
