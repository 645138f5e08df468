package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.registry.StandardTypes;

/** Lists of numbers and points as typed arrays: what is written, what is read, what is refused. */
class TypedArraysTest {
  private static final List<String> UNKNOWN = List.of("NobodyKnows");
  private static final String ONE = "3ff0000000000000";
  private static final String TWO = "4000000000000000";
  private static final String THREE = "4008000000000000";
  private static final String ONE_LITTLE = "000000000000f03f";
  private static final String TWO_LITTLE = "0000000000000040";
  private static final String THREE_LITTLE = "0000000000000840";

  /** A message with a list of either kind. */
  private static final class Lists extends U2SAData {
    private static final Schema<Lists> SCHEMA = Schema.of(Lists.class, Lists::new, U2SAData.TYPE);
    private static final ValueField<Lists, List<Double>> NUMBERS = SCHEMA.numbers("n", "m");
    private static final ValueField<Lists, List<Point>> POINTS = SCHEMA.points("p", "m");
    private static final MessageType<Lists> TYPE = SCHEMA.build();

    @Override
    public MessageType<Lists> type() {
      return TYPE;
    }

    static Lists of(List<Double> numbers, List<Point> points) {
      Lists lists = new Lists();
      lists.put(NUMBERS, numbers);
      lists.put(POINTS, points);
      return lists;
    }
  }

  private final MessageCodec compact =
      new MessageCodec(MessageTypes.of(List.of(Lists.TYPE)), WireForm.COMPACT);

  private Lists decoded(String hex) throws MalformedMessageException {
    return (Lists)
        compact.decode(Lists.TYPE.chain(), HexFormat.of().parseHex(hex.replace(" ", "")));
  }

  private static List<Double> numbers(Lists lists) {
    return lists.get(Lists.NUMBERS);
  }

  private static List<Point> points(Lists lists) {
    return lists.get(Lists.POINTS);
  }

  @Test
  void encode_compact_isAsRfc8746Says() {
    Lists lists = Lists.of(List.of(1.0, 2.0), List.of(Point.of(1.0, 2.0, 3.0)));

    assertThat(HexFormat.of().formatHex(compact.encode(lists)))
        .isEqualTo(
            ("a2 616e d856 50" + ONE_LITTLE + TWO_LITTLE)
                .concat("6170 d828 82 82 01 03 d856 58 18")
                .concat(ONE_LITTLE + TWO_LITTLE + THREE_LITTLE)
                .replace(" ", ""));
  }

  @Test
  void encode_emptyLists_areTypedTooAndReadAgain() throws MalformedMessageException {
    Lists empty = Lists.of(List.of(), List.of());
    byte[] bytes = compact.encode(empty);

    assertThat(HexFormat.of().formatHex(bytes)).isEqualTo("a2616ed856406170d82882820003d85640");
    assertThat(compact.decode(Lists.TYPE.chain(), bytes)).isEqualTo(empty);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "float16, big-endian            | d850 44 3c00 4000",
        "float32, big-endian            | d851 48 3f800000 40000000",
        "float64, big-endian            | d852 50 3ff0000000000000 4000000000000000",
        "float16, little-endian         | d854 44 003c 0040",
        "float32, little-endian         | d855 48 0000803f 00000040",
        "float64, little-endian         | d856 50 000000000000f03f 0000000000000040",
        "in pieces, between two numbers | d852 5f 4a 3ff00000000000004000 46 000000000000 ff",
        "behind a tag that says nothing | d9d9f7 d852 50 3ff0000000000000 4000000000000000",
        "plain                          | 82 01 f94000",
        "plain, with a tag              | d9d9f7 82 01 02",
      })
  void decode_numbersInAnyForm_areTheSame(String form, String hex)
      throws MalformedMessageException {
    assertThat(numbers(decoded("a1 616e" + hex))).as(form).containsExactly(1.0, 2.0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "82 82 01 03 d852 58 18" + ONE + TWO + THREE + " | float64, big-endian",
        "82 82 01 03 d856 58 18" + ONE_LITTLE + TWO_LITTLE + THREE_LITTLE + " | little-endian",
        "82 82 01 03 d854 46 003c 0040 0042 | float16",
        "82 82 01 03 83 01 02 03 | plain numbers",
        "9f 9f 01 03 ff 83 01 02 03 ff | of indefinite lengths",
        "82 c1 82 01 03 83 01 02 03 | with a tag that says nothing",
      })
  void decode_rowsInAnyForm_arePoints(String hex, String form) throws MalformedMessageException {
    assertThat(points(decoded("a1 6170 d828" + hex)))
        .as(form)
        .containsExactly(Point.of(1.0, 2.0, 3.0));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a1 616e d856 47 00000000000000   | Lists.n  | whole float64, not 7 bytes",
        "a1 616e d855 43 000000           | Lists.n  | whole float32, not 3 bytes",
        "a1 616e d850 41 00               | Lists.n  | whole float16, not 1 bytes",
        "a1 616e d852 48 7ff8000000000000 | Lists.n  | finite numbers, not NaN",
        "a1 616e d850 42 7c00             | Lists.n  | finite numbers, not Infinity",
        "a1 616e d853 50 " + ONE + TWO + "| Lists.n  | expected an array, not a byte string",
        "a1 616e d857 50 " + ONE + TWO + "| Lists.n  | expected an array, not a byte string",
        "a1 616e d840 42 0102             | Lists.n  | expected an array, not a byte string",
        "a1 616e d856 82 01 02            | Lists.n  | expected a byte string, not an array",
        "a1 616e d856 58 20 00            | Lists.n  | that fits into the message",
        "a1 616e d856 5bffffffffffffffff  | Lists.n  | that fits into the message",
        "a1 616e d856                     | Lists.n  | not the end",
        "a1 6170 d828 82 82 01 02 82 01 02             | Lists.p | the dimensions [n, 3]",
        "a1 6170 d828 82 83 01 03 01 83 01 02 03       | Lists.p | the dimensions [n, 3]",
        "a1 6170 d828 82 81 03 83 01 02 03             | Lists.p | expected a 64-bit integer",
        "a1 6170 d828 82 82 20 03 83 01 02 03          | Lists.p | the dimensions [n, 3]",
        "a1 6170 d828 82 82 02 03 83 01 02 03          | Lists.p | 2 times 3 numbers",
        "a1 6170 d828 82 82 1b7fffffffffffffff 03 80   | Lists.p | at most 100000 elements",
        "a1 6170 d828 82 82 1a000186a1 03 80           | Lists.p | at most 100000 elements",
        "a1 6170 d828 83 82 01 03 83 01 02 03 00       | Lists.p | numbers and the end",
        "a1 6170 d828 81 82 01 03                      | Lists.p | not the end",
        "a1 6170 d828 82 82 01 03 d840 43 010203       | Lists.p | not a byte string",
        "a1 6170 d828 82 82 01 03 d850 46 7e00 0000 0000 | Lists.p | finite numbers",
        "a1 6170 d856 48 " + ONE_LITTLE + "            | Lists.p | expected an array",
      })
  void decode_wrongTypedArray_isRefusedWithWhatWasExpected(String hex, String where, String what) {
    assertThatThrownBy(() -> decoded(hex))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining(where)
        .hasMessageContaining(what);
  }

  @Test
  void decode_moreNumbersThanAListMayHave_areRefused() {
    String floats = "d850 5a" + HexFormat.of().toHexDigits(200_002) + "0000".repeat(100_001);
    assertThatThrownBy(() -> decoded("a1 616e" + floats))
        .hasMessageContaining("at most 100000 elements");
  }

  /** More than a byte string may have otherwise: what bounds points is the message. */
  @Test
  void encode_asManyPointsAsFitIntoAMessage_areReadAgain() throws MalformedMessageException {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < 43_600; i++) {
      points.add(Point.of(i, -i, 0.5 * i));
    }
    byte[] bytes = compact.encode(Lists.of(List.of(), points));

    assertThat(bytes.length).isGreaterThan(Limits.BYTE_STRING_BYTES);
    assertThat(points((Lists) compact.decode(Lists.TYPE.chain(), bytes))).isEqualTo(points);
  }

  /** What a reader shows of a class that it lacks, and what it relays, is what was meant. */
  @ParameterizedTest
  @EnumSource(WireForm.class)
  void decode_inAnUnknownClass_areListsAndRelayedAsSuch(WireForm relayed)
      throws MalformedMessageException {
    PlannedPath path =
        new PlannedPath()
            .planner("Planner")
            .status(PathStatus.values()[0])
            .points(List.of(Point.of(1.0, 2.0, 3.0), Point.of(4.0, 5.0, 6.0)));
    MessageCodec knowing = new MessageCodec(StandardTypes.registry(), WireForm.COMPACT);
    MessageCodec ignorant = new MessageCodec(MessageTypes.of(List.of()), relayed);

    U2SAData opaque = ignorant.decode(path.typeChain(), knowing.encode(path));

    assertThat(opaque.unknownFields())
        .containsEntry("points", List.of(List.of(1.0, 2.0, 3.0), List.of(4.0, 5.0, 6.0)));
    assertThat(knowing.decode(path.typeChain(), ignorant.encode(opaque))).isEqualTo(path);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "d856 50 000000000000f03f 0000000000000040 | [1.0, 2.0]",
        "d828 82 82 02 01 82 01 02                 | [[1.0], [2.0]]",
        "d828 82 82 00 05 80                       | []",
        "d840 42 0102                              | 2 bytes",
      })
  void decode_unknownField_isKeptAsTheList(String hex, String expected)
      throws MalformedMessageException {
    U2SAData read =
        compact.decode(UNKNOWN, HexFormat.of().parseHex(("a1 6171" + hex).replace(" ", "")));
    Map<String, Object> fields = read.unknownFields();
    assertThat(fields.get("q")).hasToString(expected);
  }
}
