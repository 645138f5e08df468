package org.u2sa.messages.cbor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A field's name, written eight bytes at a time; and flags, a byte each. */
class FieldKeyTest {
  private static byte[] bytes(String name) {
    CborOutput out = new CborOutput(WireForm.READABLE, 1);
    out.key(FieldKey.ofName(name));
    return out.toBytes();
  }

  private static CborInput input(String name) {
    return new CborInput(bytes(name));
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
  void key_ofAnyLength_isTextOnTheWire(String name) {
    byte[] utf8 = name.getBytes(StandardCharsets.UTF_8);
    byte[] written = bytes(name);

    assertThat(Arrays.copyOfRange(written, written.length - utf8.length, written.length))
        .isEqualTo(utf8);
    assertThat(input(name).text()).isEqualTo(name);
  }

  /** All bytes before and after the name stay as they are, with room for its last word or not. */
  @Test
  void key_atTheEndOfTheBuffer_isWholeToo() {
    for (int room = 0; room < 24; room++) {
      CborOutput out = new CborOutput(WireForm.READABLE, room);
      out.flag(true);
      out.key(FieldKey.ofName("thetaDoubleDot"));
      out.flag(false);
      assertThat(HexFormat.of().formatHex(out.toBytes()))
          .isEqualTo("f5" + "6e7468657461446f75626c65446f74" + "f4");
    }
  }

  @Test
  void take_otherOrCutOffBytes_readsNothing() {
    CborInput in = input("thetaDoubleDot");

    assertThat(in.take(FieldKey.ofName("thetaDoubleDop"))).isFalse();
    assertThat(in.take(FieldKey.ofName("thetaDoubleDotSigma"))).isFalse();
    assertThat(in.offset()).isZero();
    assertThat(in.take(FieldKey.ofName("thetaDoubleDot"))).isTrue();
    assertThat(in.isAtEnd()).isTrue();
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
