package org.u2sa.messages.cbor;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;
import net.jqwik.api.constraints.StringLength;
import org.junit.jupiter.api.Test;

/** Texts that are found again must be those of the bytes, whatever was read before. */
class RecentTextsTest {
  private final RecentTexts texts = new RecentTexts();

  private String read(String text, int before, int behind) {
    byte[] utf8 = text.getBytes(UTF_8);
    byte[] bytes = new byte[before + utf8.length + behind];
    Arrays.fill(bytes, (byte) 0xFF);
    System.arraycopy(utf8, 0, bytes, before, utf8.length);
    return texts.text(bytes, before, utf8.length);
  }

  @Test
  void text_again_isTheSameObject() {
    String name = read("State Estimator", 3, 0);
    assertThat(name).isEqualTo("State Estimator");
    assertThat(read("State Estimator", 0, 20)).isSameAs(name);
  }

  @Test
  void text_ofEveryLengthAndWithZeros_isWhole() {
    for (int length = 0; length <= RecentTexts.LONGEST; length++) {
      String zeros = "\0".repeat(length);
      String letters = "x".repeat(length);
      for (int behind : new int[] {0, 3, 8, 30}) {
        assertThat(read(zeros, 1, behind)).isEqualTo(zeros);
        assertThat(read(letters, 1, behind)).isEqualTo(letters);
      }
    }
  }

  @Test
  void text_notOfAscii_isLeftToOthers() {
    assertThat(read("größe", 0, 0)).isNull();
    assertThat(read("abcdefghijklmnopqrstö", 0, 0)).isNull();
  }

  /**
   * As names of a fleet are: alike but for a few letters, at the beginning, in the middle or end.
   */
  @Test
  void text_alikeButForALetter_isToldApart() {
    for (int place = 0; place < RecentTexts.LONGEST; place++) {
      for (char letter = '!'; letter <= '~'; letter++) {
        StringBuilder name = new StringBuilder("a".repeat(RecentTexts.LONGEST));
        name.setCharAt(place, letter);
        assertThat(read(name.toString(), 0, 0)).isEqualTo(name.toString());
      }
    }
  }

  @Property(tries = 200)
  void text_manyInAnyOrder_areAlwaysThoseOfTheBytes(
      @ForAll @Size(min = 1, max = 40) List<@StringLength(max = 23) String> some) {
    Map<String, String> expected = new HashMap<>();
    List<String> twice = new ArrayList<>(some);
    twice.addAll(some);
    for (String text : twice) {
      byte[] utf8 = text.getBytes(UTF_8);
      if (utf8.length <= RecentTexts.LONGEST && utf8.length == text.length()) {
        expected.put(text, read(text, text.length() % 5, text.length() % 11));
      }
    }
    expected.forEach((text, read) -> assertThat(read).isEqualTo(text));
  }
}
