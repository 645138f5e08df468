package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;

/** The examples of RFC 8949: appendix A, and those of appendix F that are not well-formed. */
class CborInputTest {
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  private static CborInput input(String hex) {
    return new CborInput(HexFormat.of().parseHex(hex.replace(" ", "")));
  }

  /** What a key of a type that nobody knows says. */
  private Object value(String hex) throws MalformedMessageException {
    byte[] bytes = HexFormat.of().parseHex("a16171" + hex.replace(" ", ""));
    return codec.decode(List.of("NobodyKnows"), bytes).unknownFields().get("q");
  }

  @ParameterizedTest
  @CsvSource({
    "00, 0",
    "01, 1",
    "0a, 10",
    "17, 23",
    "1818, 24",
    "1819, 25",
    "1864, 100",
    "1903e8, 1000",
    "1a000f4240, 1000000",
    "1b000000e8d4a51000, 1000000000000",
    "20, -1",
    "29, -10",
    "3863, -100",
    "3903e7, -1000",
    "1b7fffffffffffffff, 9223372036854775807",
    "3b7fffffffffffffff, -9223372036854775808",
    "c11a514b67b0, 1363896240"
  })
  void count_ofAppendixA_isTheInteger(String hex, long expected) throws MalformedMessageException {
    CborInput in = input(hex);
    assertThat(in.count()).isEqualTo(expected);
    assertThat(in.isAtEnd()).isTrue();
    assertThat(input(hex).number()).isEqualTo((double) expected);
    assertThat(value(hex)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "f90000, 0.0",
    "f98000, -0.0",
    "f93c00, 1.0",
    "fb3ff199999999999a, 1.1",
    "f93e00, 1.5",
    "f97bff, 65504.0",
    "fa47c35000, 100000.0",
    "fa7f7fffff, 3.4028234663852886e+38",
    "fb7e37e43c8800759c, 1.0e+300",
    "f90001, 5.960464477539063e-8",
    "f90400, 0.00006103515625",
    "f9c400, -4.0",
    "fbc010666666666666, -4.1",
    "f97c00, Infinity",
    "f97e00, NaN",
    "f9fc00, -Infinity",
    "fa7f800000, Infinity",
    "fa7fc00000, NaN",
    "faff800000, -Infinity",
    "fb7ff0000000000000, Infinity",
    "fb7ff8000000000000, NaN",
    "fbfff0000000000000, -Infinity",
    "c1fb41d452d9ec200000, 1363896240.5",
    "1bffffffffffffffff, 18446744073709551615",
    "3bffffffffffffffff, -18446744073709551616"
  })
  void number_ofAppendixA_isTheNumber(String hex, Double expected) {
    CborInput in = input(hex);
    assertThat(in.number()).isEqualTo(expected);
    assertThat(in.isAtEnd()).isTrue();
    double[] all = new double[2];
    input(hex + hex).numbers(all);
    assertThat(all).containsExactly(expected, expected);
  }

  @ParameterizedTest
  @CsvSource({
    "60, ''",
    "6161, a",
    "6449455446, IETF",
    "62225c, '\"\\'",
    "62c3bc, ü",
    "63e6b0b4, 水",
    "64f0908591, 𐅑",
    "7f657374726561646d696e67ff, streaming",
    "c074323031332d30332d32315432303a30343a30305a, 2013-03-21T20:04:00Z",
    "d82076687474703a2f2f7777772e6578616d706c652e636f6d, http://www.example.com"
  })
  void text_ofAppendixA_isTheText(String hex, String expected) throws MalformedMessageException {
    CborInput in = input(hex);
    assertThat(in.text()).isEqualTo(expected);
    assertThat(in.isAtEnd()).isTrue();
    assertThat(value(hex)).isEqualTo(expected);
  }

  @Test
  void list_ofAppendixA_isTheList() throws MalformedMessageException {
    List<Object> nested = List.of(1L, List.of(2L, 3L), List.of(4L, 5L));
    for (String hex :
        List.of(
            "8301820203820405",
            "9f018202039f0405ffff",
            "9f01820203820405ff",
            "83018202039f0405ff",
            "83019f0203ff820405")) {
      assertThat(value(hex)).as(hex).isEqualTo(nested);
    }
    assertThat(value("80")).isEqualTo(List.of());
    assertThat(value("9fff")).isEqualTo(List.of());
    assertThat((List<?>) value("98190102030405060708090a0b0c0d0e0f101112131415161718181819"))
        .hasSize(25)
        .last()
        .isEqualTo(25L);
  }

  @Test
  void map_ofAppendixA_isTheMap() throws MalformedMessageException {
    assertThat(value("a0")).isEqualTo(Map.of());
    assertThat(value("a26161016162820203")).isEqualTo(Map.of("a", 1L, "b", List.of(2L, 3L)));
    assertThat(value("bf61610161629f0203ffff")).isEqualTo(Map.of("a", 1L, "b", List.of(2L, 3L)));
    assertThat(value("826161a161626163")).isEqualTo(List.of("a", Map.of("b", "c")));
    assertThat(value("bf6346756ef563416d7421ff")).isEqualTo(Map.of("Fun", true, "Amt", -2L));
  }

  /** Whatever is well-formed can be skipped. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "00",
        "1b000000e8d4a51000",
        "3863",
        "fb3ff199999999999a",
        "f4",
        "f5",
        "f6",
        "f7",
        "f0",
        "f8ff",
        "40",
        "4401020304",
        "5f42010243030405ff",
        "d74401020304",
        "d818456449455446",
        "7f657374726561646d696e67ff",
        "c249010000000000000000",
        "a201020304",
        "bf61610161629f0203ffff",
        "a56161614161626142616361436164614461656145",
        "8301820203820405",
        "9f01820203820405ff"
      })
  void skip_ofAppendixA_isAllOfIt(String hex) {
    CborInput in = input(hex + "00");
    in.skip(Limits.DEPTH);
    assertThat(in.count()).isZero();
    assertThat(in.isAtEnd()).isTrue();
  }

  /** Appendix F: not well-formed. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "18",
        "19",
        "1a",
        "1b",
        "1901",
        "1a0102",
        "1b01020304050607",
        "38",
        "58",
        "78",
        "98",
        "9a01ff00",
        "b8",
        "d8",
        "f8",
        "f900",
        "fa0000",
        "fb000000",
        "41",
        "61",
        "5affffffff00",
        "5bffffffffffffffff010203",
        "7affffffff00",
        "7b7fffffffffffffff010203",
        "81",
        "818181818181818181",
        "8200",
        "a1",
        "a20102",
        "a100",
        "a2000000",
        "c0",
        "5f4100",
        "7f6100",
        "9f",
        "9f0102",
        "bf",
        "bf01020102",
        "819f",
        "9f8000",
        "9f9f9f9f9fffffffff",
        "9f819f819f9fffffff",
        "1c",
        "1d",
        "1e",
        "3c",
        "3d",
        "3e",
        "5c",
        "5d",
        "5e",
        "7c",
        "7d",
        "7e",
        "9c",
        "9d",
        "9e",
        "bc",
        "bd",
        "be",
        "dc",
        "dd",
        "de",
        "fc",
        "fd",
        "fe",
        "5f00ff",
        "5f21ff",
        "5f6100ff",
        "5f80ff",
        "5fa0ff",
        "5fc000ff",
        "5fe0ff",
        "7f4100ff",
        "5f5f4100ffff",
        "7f7f6100ffff",
        "ff",
        "81ff",
        "8200ff",
        "a1ff",
        "a1ff00",
        "a100ff",
        "a20000ff",
        "9f81ff",
        "9f829f819f9fffffffff",
        "bf00ff",
        "bf000000ff",
        "1f",
        "3f",
        "df"
      })
  void skip_ofWhatIsNotWellFormed_isRefused(String hex) {
    assertThatThrownBy(() -> input(hex).skip(Limits.DEPTH))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("expected ");
  }

  @Test
  void skip_deeperThanTheLimit_isRefused() {
    String deepest = "81".repeat(Limits.DEPTH) + "00";
    input(deepest).skip(Limits.DEPTH);
    assertThatThrownBy(() -> input("81" + deepest).skip(Limits.DEPTH))
        .hasMessage("expected at most 8 levels of nesting");
  }

  /** One more than a long holds, either way. */
  @ParameterizedTest
  @ValueSource(strings = {"1b8000000000000000", "3b8000000000000000", "1bffffffffffffffff"})
  void count_of65Bits_isRefused(String hex) {
    assertThatThrownBy(() -> input(hex).count()).hasMessageContaining("a 64-bit integer");
  }

  /** Lengths are checked before memory is taken. */
  @ParameterizedTest
  @ValueSource(strings = {"9a00000003 0102", "9affffffff", "ba00000003 6161", "bbffffffffffffffff"})
  void open_longerThanTheMessage_isRefusedAtOnce(String hex) {
    CborInput in = input(hex);
    boolean isMap = hex.startsWith("b");
    assertThatThrownBy(() -> skipOpened(in, isMap))
        .hasMessageEndingWith("that fits into the message");
  }

  private static void skipOpened(CborInput in, boolean isMap) {
    if (isMap) {
      in.map();
    } else {
      in.array();
    }
  }

  @Test
  void text_inPieces_isLimitedAsAWhole() {
    String piece = "798000" + "61".repeat(0x8000);
    String end = "ff";
    assertThat(input("7f" + piece + end).text()).hasSize(0x8000);
    assertThatThrownBy(() -> input("7f" + piece + piece + "6161" + end).text())
        .hasMessage("expected at most 65536 bytes of text");
  }

  @Test
  void numbers_cutOffInTheLast_areRefused() {
    assertThatThrownBy(() -> input("fb3ff8000000000000 fb3ff80000000000").numbers(new double[2]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("expected ");
  }

  /** The outermost map is the first level, whether the type is known or not. */
  @ParameterizedTest
  @ValueSource(strings = {"StateInformation", "NobodyKnows"})
  void decode_asDeepAsMayBe_isTakenAndNoDeeper(String type) throws MalformedMessageException {
    String deepest = "a16171" + "81".repeat(Limits.DEPTH - 1) + "00";
    List<String> chain = List.of(type);
    assertThat(codec.decode(chain, HexFormat.of().parseHex(deepest))).isNotNull();
    byte[] deeper = HexFormat.of().parseHex("a16171" + "81".repeat(Limits.DEPTH) + "00");
    assertThatThrownBy(() -> codec.decode(chain, deeper))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("levels of nesting");
  }

  @Test
  void count_underSeveralTags_isTheInteger() {
    assertThat(input("c1d818c10a").count()).isEqualTo(10L);
  }

  /**
   * {"goals": [{"type": ["GoalInformation"], "uid": "7", "origin": ["a", 1]}]}, "type" in a longer
   * form.
   */
  @Test
  void decode_originWithinAList_isNotTheMessages() throws MalformedMessageException {
    String goal =
        "a3 7804 74797065 81 6f 476f616c496e666f726d6174696f6e 63 756964 61 37 66 6f726967696e 82 6161 01";
    byte[] bytes = HexFormat.of().parseHex(("a1 65 676f616c73 81" + goal).replace(" ", ""));
    GoalList list = (GoalList) codec.decode(GoalList.TYPE.chain(), bytes);
    assertThat(list.origin()).isEmpty();
    assertThat(list.goals()).singleElement().extracting(GoalInformation::uid).isEqualTo("7");
  }

  /** {"ranges": [0, 0, …]}, one more than a list may have. */
  @Test
  void decode_moreNumbersThanTheLimit_areRefusedBeforeTheyAreRead() {
    byte[] head = HexFormat.of().parseHex("a16672616e6765739a000186a1");
    byte[] bytes = Arrays.copyOf(head, head.length + Limits.LIST_ELEMENTS + 1);
    assertThatThrownBy(() -> codec.decode(RangeScan.TYPE.chain(), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessage("RangeScan.ranges, byte 13: expected at most 100000 elements");
  }
}
