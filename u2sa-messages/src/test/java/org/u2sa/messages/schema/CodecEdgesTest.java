package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.cbor.Cbor;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.StopCommand;

/** What is just within what a reader takes, and just outside. */
class CodecEdgesTest {
  private static final List<String> UNKNOWN = List.of("NobodyKnows");
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  private U2SAData decode(List<String> chain, String hex) throws MalformedMessageException {
    return codec.decode(chain, HexFormat.of().parseHex(hex.replace(" ", "")));
  }

  /** {"q": {"a": 1, "b": true}} */
  @Test
  void decode_mapOfAnUnknownField_isKeptAndWrittenAgain() throws MalformedMessageException {
    String hex = "a1 6171 a2 6161 01 6162 f5";
    U2SAData read = decode(UNKNOWN, hex);

    assertThat(read.unknownFields()).isEqualTo(Map.of("q", Map.of("a", 1L, "b", true)));
    assertThat(HexFormat.of().formatHex(read.serialize())).isEqualTo(hex.replace(" ", ""));
  }

  /** {"q": {"a": 1, "a": 2}} */
  @Test
  void decode_keyTwiceInAMapOfAnUnknownField_isRefused() {
    assertThatThrownBy(() -> decode(UNKNOWN, "a1 6171 a2 6161 01 6161 02"))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("the key \"a\" occurs twice");
  }

  /** {"origin": …}: a text, and an array of three. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "a1 666f726967696e 6161",
        "a1 666f726967696e 83 6161 01 02",
        "a1 666f726967696e a1 6161 01"
      })
  void decode_originThatIsNoPair_isRefused(String hex) {
    assertThatThrownBy(() -> decode(StopCommand.TYPE.chain(), hex))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("StopCommand.origin");
  }

  @Test
  void nearest_chainOfTheLongestLength_isTaken() throws MalformedMessageException {
    List<String> longest = Collections.nCopies(Limits.DEPTH, "Unheard");
    assertThat(StandardTypes.registry().nearest(longest)).isSameAs(OpaqueMessage.TYPE);
  }

  @Test
  void text_pairOfSurrogates_isACharacter() throws MalformedMessageException {
    Waypoint goal = new Waypoint().uid("a😀b😀").x(1).y(2).horizontalThreshold(3);
    assertThat(codec.decode(goal.typeChain(), goal.serialize())).isEqualTo(goal);
    for (String broken : List.of("😀\ude00", "\ude00\ud83d", "a\ud83d", "\ud83d\ud83d\ude00")) {
      assertThatThrownBy(() -> new Waypoint().uid(broken))
          .hasMessageContaining("without unpaired surrogates");
    }
  }

  @Test
  void setText_false_isFalse() {
    Waypoint goal = new Waypoint().completed(true);
    Waypoint.TYPE.field("completed").orElseThrow().setText(goal, " False ");
    assertThat(goal.completed()).isFalse();
  }

  /** What tools are told of a field's values. */
  @Test
  void kind_ofFields_isTheirValues() {
    assertThat(Waypoint.TYPE.field("uid").orElseThrow().kind()).isEqualTo(Kind.STRING);
    assertThat(Waypoint.TYPE.field("completed").orElseThrow().kind()).isEqualTo(Kind.BOOLEAN);
    assertThat(GoalList.TYPE.field("goals").orElseThrow().kind()).isEqualTo(Kind.MESSAGE_LIST);
    assertThat(ScalarKinds.POINT.kind()).isEqualTo(Kind.POINT);
  }

  /** {"goals": 1} and {"goals": [1]}. */
  @Test
  void decode_listThatIsNone_isToldWhatWasExpected() {
    assertThatThrownBy(() -> decode(GoalList.TYPE.chain(), "a1 65676f616c73 01"))
        .hasMessageContaining("an array");
    assertThatThrownBy(() -> decode(GoalList.TYPE.chain(), "a1 65676f616c73 81 01"))
        .hasMessageContaining("a map");
  }

  /** {"origin": 1}. */
  @Test
  void decode_originThatIsANumber_isToldThatAnArrayWasExpected() {
    assertThatThrownBy(() -> decode(StopCommand.TYPE.chain(), "a1 666f726967696e 01"))
        .hasMessageContaining("an array of sender and sequence");
  }

  /** The keys of a message in a list are not the outer one's: its origin comes after them. */
  @Test
  void decode_originAfterAListOfMessages_isTheMessages() throws MalformedMessageException {
    Waypoint goal = new Waypoint().uid("1").x(1).y(2).horizontalThreshold(3);
    GoalList list = new GoalList().goals(List.of(goal));
    String bytes = HexFormat.of().formatHex(list.serialize());
    assertThat(bytes)
        .startsWith("a2") // goals and upcoming
        .contains("65676f616c73");

    U2SAData read =
        decode(list.typeChain(), "a3" + bytes.substring(2) + "666f726967696e 82 6161 07");

    assertThat(read.origin()).contains(new Origin("a", 7));
    assertThat(((GoalList) read).goals()).hasSize(1);
  }

  @Test
  void decode_exactlyTheMostBytes_areRead() throws MalformedMessageException {
    byte[] bytes = new byte[Limits.PAYLOAD_BYTES];
    byte[] begin = HexFormat.of().parseHex("a1" + "6171" + "9f"); // {"q": [_ … ]}
    System.arraycopy(begin, 0, bytes, 0, begin.length);
    bytes[bytes.length - 1] = (byte) 0xff; // in between numbers 0, more than a list may have
    assertThatThrownBy(() -> codec.decode(UNKNOWN, bytes)).hasMessageContaining("elements");
    byte[] more = new byte[Limits.PAYLOAD_BYTES + 1];
    assertThatThrownBy(() -> codec.decode(UNKNOWN, more))
        .hasMessageContaining("at most " + Limits.PAYLOAD_BYTES + " bytes");
  }

  /**
   * A constant of later versions in an optional field is as if the field were absent; its key may
   * still not come twice, whether what follows is in order or not.
   */
  @Test
  void decode_constantUnknown_isAbsentAndItsKeyCannotComeAgain() throws MalformedMessageException {
    ObjectDescription object = new ObjectDescription().uid("o").level(ObjectLevel.AVOID_ALWAYS);
    object.x(1.0).y(2.0).confidence(0.5);
    byte[] bytes = object.serialize();
    String hex = HexFormat.of().formatHex(bytes);
    String known = text("AVOID_ALWAYS");
    assertThat(hex).contains(known);
    String later = hex.replace(known, text("AVOID_NEVERS"));

    ObjectDescription read =
        (ObjectDescription) codec.decode(object.typeChain(), HexFormat.of().parseHex(later));
    assertThat(read.level()).isEmpty();
    assertThat(read.confidence()).hasValue(0.5);

    int pairs = bytes[0] & Cbor.INFO;
    for (String value : List.of("AVOID_NEVERS", "AVOID_ALWAYS")) {
      byte[] twice =
          HexFormat.of()
              .parseHex(withPairs(pairs + 1) + later.substring(2) + text("level") + text(value));
      assertThatThrownBy(() -> codec.decode(object.typeChain(), twice))
          .isInstanceOf(MalformedMessageException.class)
          .hasMessageContaining("ObjectDescription.level")
          .hasMessageContaining("the key occurs twice");
    }
  }

  private static String withPairs(int pairs) {
    return HexFormat.of().toHexDigits((byte) (Cbor.MAP | pairs));
  }

  private static String text(String ascii) {
    byte[] bytes = ascii.getBytes(StandardCharsets.US_ASCII);
    return HexFormat.of().toHexDigits((byte) (Cbor.TEXT | bytes.length))
        + HexFormat.of().formatHex(bytes);
  }
}
