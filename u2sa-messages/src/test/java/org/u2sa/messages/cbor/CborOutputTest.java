package org.u2sa.messages.cbor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The shortest form of RFC 8949, 4.2.1, on both sides of each length. */
class CborOutputTest {
  @ParameterizedTest
  @CsvSource({
    "0, 00",
    "23, 17",
    "24, 1818",
    "255, 18ff",
    "256, 190100",
    "65535, 19ffff",
    "65536, 1a00010000",
    "4294967295, 1affffffff",
    "4294967296, 1b0000000100000000",
    "9223372036854775807, 1b7fffffffffffffff",
    "-1, 20",
    "-24, 37",
    "-25, 3818",
    "-256, 38ff",
    "-257, 390100",
    "-9223372036854775808, 3b7fffffffffffffff"
  })
  void count_anyInteger_isAsShortAsCanBe(long value, String hex) {
    CborOutput out = new CborOutput();
    out.count(value);
    assertThat(HexFormat.of().formatHex(out.toBytes())).isEqualTo(hex);
  }

  @Test
  void text_longerThanTheFirstBuffer_isWhole() {
    for (int length = 480; length < 1100; length++) {
      CborOutput out = new CborOutput();
      String text = "é".repeat(length / 2) + "e".repeat(length % 2);
      out.text(text);
      out.number(1.5);
      CborInput in = new CborInput(out.toBytes());
      assertThat(in.text()).isEqualTo(text);
      assertThat(in.number()).isEqualTo(1.5);
      assertThat(in.isAtEnd()).isTrue();
    }
  }
}
