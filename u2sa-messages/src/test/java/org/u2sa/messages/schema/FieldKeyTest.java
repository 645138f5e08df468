package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A field's name, written and recognised eight bytes at a time; and flags, a byte each. */
class FieldKeyTest {
  private static byte[] bytes(String name) {
    CborOutput out = new CborOutput(1);
    out.key(new FieldKey(name));
    return out.toBytes();
  }

  private static boolean begins(String name, CborInput in) {
    FieldKey key = new FieldKey(name);
    return (in.word() & key.mask()) == key.beginning();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "x",
        "sevenBy",
        "eightByt",
        "fifteenBytesLon",
        "aNameThatTakesMoreThanTwentyThree",
        "größe"
      })
  void key_ofAnyLength_isTextOnTheWireAndRecognised(String name) {
    byte[] utf8 = name.getBytes(StandardCharsets.UTF_8);
    byte[] written = bytes(name);
    CborInput in = new CborInput(written);

    assertThat(Arrays.copyOfRange(written, written.length - utf8.length, written.length))
        .isEqualTo(utf8);
    assertThat(new CborInput(written).text()).isEqualTo(name);
    assertThat(begins(name, in)).isTrue();
    assertThat(in.take(new FieldKey(name))).isTrue();
    assertThat(in.isAtEnd()).isTrue();
  }

  @Test
  void take_nameThatEndsOtherwise_isNotTaken() {
    CborInput in = new CborInput(bytes("thetaDoubleDot"));

    assertThat(begins("thetaDoubleDop", in)).isTrue();
    assertThat(in.take(new FieldKey("thetaDoubleDop"))).isFalse();
    assertThat(begins("phiDot", in)).isFalse();
    assertThat(in.offset()).isZero();
  }

  @Test
  void take_inputEndsWithinTheName_isNotTaken() {
    byte[] whole = bytes("thetaDoubleDot");
    CborInput in = new CborInput(Arrays.copyOf(whole, whole.length - 1));

    assertThat(in.take(new FieldKey("thetaDoubleDot"))).isFalse();
  }

  @Test
  void word_fewerThanEightBytesLeft_isFilledUpWithZeros() {
    assertThat(new CborInput(new byte[] {1, 2}).word()).isEqualTo(0x0102_0000_0000_0000L);
  }

  @Test
  void flags_otherThanTrueAndFalse_areRefused() {
    assertThat(Flags.of(List.of(true, false, true))).isEqualTo(List.of(true, false, true));
    assertThatThrownBy(() -> Flags.of(List.of(1)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("true or false");
  }
}
