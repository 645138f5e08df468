package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;

class HostileBytesTest {
  private static final List<String> STATE = List.of("StateInformation");
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  /** Hexadecimal CBOR by hand: a1 is a map of one, 61 78 is "x", fb a float64. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a16178fb7ff8000000000000 | StateInformation.x, byte 12: StateInformation.x: expected a finite number [m], not \"NaN\"",
        "a16178fb7ff0000000000000 | not \"Infinity\"",
        "a1617861 79 | expected a number, not text",
        "a16178f6 | expected a number, not null",
        "a26178fb00000000000000006178fb0000000000000000 | StateInformation.x, byte 14: the key occurs twice",
        "a2617100617100 | StateInformation.q, byte 6: the key occurs twice",
        "a0a0 | expected the end of the message, not more bytes",
        "a000 | expected the end of the message, not more bytes",
        "80 | expected a map, not an array",
        "00 | expected a map",
        "ff | StateInformation, byte 1",
        "a1 | StateInformation, byte 1",
        "a16e7265666572656e63654672616d65634f4d47 | \"OMG\" is not a reference frame",
        "a16974696d657374616d70c249ffffffffffffffffff | expected a 64-bit integer",
        "a16a73656e736f724e616d657affffffff | StateInformation.sensorName",
        "a16a73656e736f724e616d657bffffffffffffffff | StateInformation.sensorName",
        "a16a73656e736f724e616d657b00000001ffffffff | StateInformation.sensorName",
        "bbffffffffffffffff | StateInformation",
        "a161718181818181818181818181818181 | StateInformation.q",
        "a1617149ffff | StateInformation"
      })
  void decode_broken_saysWhereAndWhatWasExpected(String hex, String expected) {
    byte[] bytes = HexFormat.of().parseHex(hex.replace(" ", ""));

    assertThatThrownBy(() -> codec.decode(STATE, bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining(expected);
  }

  @Test
  void decode_arrayThatClaimsMoreThanThereIs_isRefused() {
    assertRefused(
        "ObjectDescription/PointCloud", "a166706f696e74739affffffff", "PointCloud.points");
    assertRefused(
        "ObjectDescription/PointCloud", "a166706f696e74739bffffffffffffffff", "PointCloud.points");
    assertRefused("GoalList", "a165676f616c739a7fffffff", "GoalList.goals");
  }

  @Test
  void decode_listLongerThanTheLimit_isRefused() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.writeBytes(HexFormat.of().parseHex("a1646e6578749f")); // next: an array without end
    for (int i = 0; i <= Limits.LIST_ELEMENTS; i++) {
      bytes.write(0x60); // ""
    }
    bytes.write(0xff);

    for (List<String> chain :
        List.of(List.of("GoalInformation", "Waypoint"), List.of("NobodyKnows"))) {
      assertThatThrownBy(() -> codec.decode(chain, bytes.toByteArray()))
          .isInstanceOf(MalformedMessageException.class)
          .hasMessageContaining("expected at most 100000 elements");
    }
  }

  @Test
  void decode_unknownTypeWithNaN_isRefused() {
    assertRefused("NobodyKnows", "a16171f97e00", "NobodyKnows.q, byte 6: expected a finite number");
  }

  /** Found by fuzzing: U+DE7B as three bytes, in places that no field's own check sees. */
  @Test
  void decode_halfASurrogatePairInWhatIsUnknown_isRefused() {
    assertRefused("NobodyKnows", "a161 71 63edb9bb".replace(" ", ""), "unpaired surrogate");
    assertRefused("NobodyKnows", "a1 63edb9bb 00".replace(" ", ""), "unpaired surrogate");
    assertRefused("NobodyKnows", "a161 71 a163edb9bb00".replace(" ", ""), "unpaired surrogate");
  }

  @Test
  void decode_payloadOverOneMebibyte_isRefusedUnread() {
    assertThatThrownBy(() -> codec.decode(STATE, new byte[Limits.PAYLOAD_BYTES + 1]))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("expected at most 1048576 bytes, not 1048577");
  }

  @Test
  void decode_textOverTheLimit_isRefused() {
    byte[] head = HexFormat.of().parseHex("a16a73656e736f724e616d657a00010001");
    byte[] bytes = Arrays.copyOf(head, head.length + Limits.TEXT_BYTES + 1);
    Arrays.fill(bytes, head.length, bytes.length, (byte) 'a');

    assertThatThrownBy(() -> codec.decode(STATE, bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("StateInformation.sensorName");
  }

  @Test
  void decode_requiredFieldMissing_isNamed() {
    assertRefused(
        "ObjectDescription/ShapeDescription/Circle",
        "a16375696461 63".replace(" ", ""),
        "ObjectDescription.x is required and missing");
  }

  static List<U2SAData> beyondThePoles() {
    ReferenceFrame earth = ReferenceFrame.GLOBAL;
    Point beyond = Point.of(8.0, 91.0, 0.0);
    return List.of(
        new StateInformation().referenceFrame(earth).x(8.0).y(91.0),
        new RangeScan().sensorName("laser").referenceFrame(earth).y(91.0).maxRange(9.0),
        new NavigationPoint().referenceFrame(earth).point(beyond),
        new Waypoint().uid("1").referenceFrame(earth).horizontalThreshold(1.0).lookAt(beyond));
  }

  @ParameterizedTest
  @MethodSource("beyondThePoles")
  void decode_latitudeBeyondThePoles_isRefusedWhateverTheField(U2SAData message) {
    byte[] bytes = codec.encode(message);

    assertThatThrownBy(() -> codec.decode(message.type().chain(), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining(": the latitude 91.0 deg is outside -90…90 deg");
  }

  @Test
  void decode_nestedWithoutTypeOrOfWrongKind_isRefused() {
    assertRefused("GoalList", "a165676f616c7381a0", "expected \"type\" as the first key");
    assertRefused(
        "GoalList",
        "a165676f616c7381a16474797065816f4f626a6563744465736372697074696f6e"
            .replace(
                "6f4f626a6563744465736372697074696f6e", "714f626a6563744465736372697074696f6e"),
        "expected a kind of GoalInformation, not [ObjectDescription]");
  }

  @Test
  void decode_brokenWithinAList_namesTheWholeWay() {
    // {"goals": [{"type": ["GoalInformation"], "uid": 7}]}
    assertRefused(
        "GoalList",
        "a165676f616c7381a26474797065816f476f616c496e666f726d6174696f6e6375696407",
        "GoalList.goals.uid, byte 36: expected text, not an integer");
  }

  @Test
  void decode_emptyChainOrEndlessOne_isRefused() {
    assertThatThrownBy(() -> codec.decode(List.of(), new byte[] {(byte) 0xa0}))
        .isInstanceOf(MalformedMessageException.class);
    assertThatThrownBy(
            () -> codec.decode(java.util.Collections.nCopies(9, "A"), new byte[] {(byte) 0xa0}))
        .isInstanceOf(MalformedMessageException.class);
  }

  @Test
  void decode_indefiniteLengthsAndShortFloats_areTaken() throws MalformedMessageException {
    U2SAData read =
        codec.decode(
            STATE, HexFormat.of().parseHex("bf6178f93e006179fa3fc000006 17a02ff".replace(" ", "")));

    assertThat(read).isEqualTo(new StateInformation().x(1.5).y(1.5).z(2.0));
  }

  private void assertRefused(String type, String hex, String expected) {
    assertThatThrownBy(() -> codec.decode(List.of(type.split("/")), HexFormat.of().parseHex(hex)))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining(expected);
  }
}
