package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.Cbor;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.registry.StandardTypes;

/** Numbers side by side: names of any length, and readers that expect other numbers than come. */
class NumberRunTest {
  /** A message with a number of each length of name from 1 to 40. */
  private static final class Named extends U2SAData {
    private static final Schema<Named> SCHEMA = Schema.of(Named.class, Named::new, U2SAData.TYPE);

    static {
      for (int length = 1; length <= 40; length++) {
        SCHEMA.optionalNumber("n".repeat(length), "m");
      }
    }

    private static final MessageType<Named> TYPE = SCHEMA.build();

    @Override
    public MessageType<Named> type() {
      return TYPE;
    }
  }

  private static final List<String> STATE = StateInformation.TYPE.chain();
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  private static Named withNumbers(int from, int step) {
    Named message = new Named();
    for (int length = from; length <= 40; length += step) {
      Named.TYPE.field("n".repeat(length)).orElseThrow().set(message, length + 0.5);
    }
    return message;
  }

  @Test
  void serialize_namesOfAnyLength_areWholeAndReadAgain() throws MalformedMessageException {
    MessageCodec named = new MessageCodec(MessageTypes.of(List.of(Named.TYPE)));
    for (int step = 1; step <= 40; step++) {
      for (int from = 1; from <= step; from++) {
        Named message = withNumbers(from, step);
        byte[] bytes = message.serialize();

        assertThat(new String(bytes, StandardCharsets.ISO_8859_1)).contains("n".repeat(from));
        for (int time = 1; time <= 2; time++) { // unexpected, then expected
          assertThat(named.decode(Named.TYPE.chain(), bytes)).isEqualTo(message);
        }
        CborInput in = new CborInput(bytes);
        in.skip(Limits.DEPTH);
        assertThat(in.isAtEnd()).isTrue();
      }
    }
  }

  /** Sensors of one type take turns: each message differs from what the reader expects. */
  @ParameterizedTest
  @EnumSource(WireForm.class)
  void decode_otherNumbersInEachMessage_areReadAsWritten(WireForm form)
      throws MalformedMessageException {
    MessageCodec formed = new MessageCodec(StandardTypes.registry(), form);
    Random random = new Random(7);
    for (int i = 0; i < 20_000; i++) {
      StateInformation state = new StateInformation().sensorName("s".repeat(random.nextInt(4)));
      long chosen = random.nextLong() & random.nextLong() & random.nextLong();
      for (StateField field : StateField.values()) {
        if ((chosen >>> field.ordinal() & 1L) != 0L) {
          state.number(field, random.nextDouble());
        }
      }
      assertThat(formed.decode(STATE, formed.encode(state)).enumerateFields())
          .isEqualTo(state.enumerateFields());
    }
  }

  private static StateInformation position(double x) {
    return new StateInformation().x(x).y(2.0).z(3.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.5, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void decode_expectedNumbersButOneOutOfBounds_isRefusedByName(double wrong)
      throws MalformedMessageException {
    BatteryState battery =
        new BatteryState().sensorName("B").voltage(12.0).current(1.0).remaining(50.0);
    byte[] bytes = battery.serialize();
    assertThat(codec.decode(battery.typeChain(), bytes)).isEqualTo(battery);
    ByteBuffer.wrap(bytes).putDouble(bytes.length - Double.BYTES, wrong);

    assertThatThrownBy(() -> codec.decode(battery.typeChain(), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("BatteryState.remaining");
  }

  /** Numbers that are whole, or shorter floats, follow an expected message of the same length. */
  @Test
  void decode_numbersInAnotherFormThanExpected_areReadTheSlowWay()
      throws MalformedMessageException {
    byte[] bytes = new StateInformation().x(1.0).serialize();
    assertThat(((StateInformation) codec.decode(STATE, bytes)).x()).hasValue(1.0);
    byte[] whole = Arrays.copyOf(bytes, bytes.length);
    whole[bytes.length - 9] = (byte) (Cbor.UNSIGNED | Cbor.EIGHT_BYTES);
    Arrays.fill(whole, bytes.length - 8, bytes.length, (byte) 0);
    whole[bytes.length - 1] = 42;

    assertThat(((StateInformation) codec.decode(STATE, whole)).x()).hasValue(42.0);
    assertThat(((StateInformation) codec.decode(STATE, bytes)).x()).hasValue(1.0);
  }

  /** The expected x and y, and behind them x once more, or y where x should be. */
  @Test
  void decode_expectedNumbersAndOneTwice_isRefused() throws MalformedMessageException {
    String pairs = "6178fb3ff00000000000006179fb4000000000000000";
    byte[] good = HexFormat.of().parseHex("a2" + pairs);
    byte[] twice = HexFormat.of().parseHex("a3" + pairs + "6178fb3ff0000000000000");
    assertThat(codec.decode(STATE, good).presenceVector()).isEqualTo(0b11L);
    for (int time = 1; time <= 3; time++) {
      assertThatThrownBy(() -> codec.decode(STATE, twice))
          .isInstanceOf(MalformedMessageException.class)
          .hasMessageContaining("StateInformation.x")
          .hasMessageContaining("the key occurs twice");
    }
    byte[] again = HexFormat.of().parseHex("a4" + pairs + pairs);
    assertThatThrownBy(() -> codec.decode(STATE, again)).hasMessageContaining("occurs twice");
  }

  @Test
  void decode_expectedNumbersCutOff_isRefusedAtTheCut() throws MalformedMessageException {
    byte[] bytes = position(1.0).serialize();
    codec.decode(STATE, bytes);
    for (int length = 1; length < bytes.length; length++) {
      byte[] cut = Arrays.copyOf(bytes, length);
      assertThatThrownBy(() -> codec.decode(STATE, cut))
          .as("%s bytes", length)
          .isInstanceOf(MalformedMessageException.class);
    }
  }

  @Test
  void copy_ofWhatWasRead_doesNotShareItsNumbers() throws MalformedMessageException {
    byte[] bytes = position(1.0).serialize();
    codec.decode(STATE, bytes);
    StateInformation first = (StateInformation) codec.decode(STATE, bytes);
    StateInformation second = (StateInformation) codec.decode(STATE, bytes);

    first.x(9.0);

    assertThat(second.x()).hasValue(1.0);
    assertThat(position(1.0).serialize()).isEqualTo(bytes);
  }

  /** More numbers are there than the map says: whichever number of pairs hashes alike. */
  @Test
  void decode_moreNumbersExpectedThanThereAre_endsWithTheMap() throws MalformedMessageException {
    MessageCodec named = new MessageCodec(MessageTypes.of(List.of(Named.TYPE)));
    for (int first = 1; first < 40; first++) {
      for (int last = first + 1; last <= Math.min(40, first + 22); last++) {
        Named message = new Named();
        for (int length = first; length <= last; length++) {
          Named.TYPE.field("n".repeat(length)).orElseThrow().set(message, 1.0);
        }
        byte[] bytes = message.serialize();
        named.decode(Named.TYPE.chain(), bytes);
        bytes[0] = (byte) (Cbor.MAP | 1);

        assertThatThrownBy(() -> named.decode(Named.TYPE.chain(), bytes))
            .hasMessageContaining("expected the end of the message");
      }
    }
  }

  /** A text, a number, and one that has a default. */
  private static final class Defaulted extends U2SAData {
    private static final Schema<Defaulted> SCHEMA =
        Schema.of(Defaulted.class, Defaulted::new, U2SAData.TYPE);
    private static final ValueField<Defaulted, String> TEXT = SCHEMA.optionalText("t");
    private static final NumberField<Defaulted> NUMBER = SCHEMA.optionalNumber("a", "m");
    private static final NumberField<Defaulted> WITH_DEFAULT = SCHEMA.number("b", "m", 1.0);
    private static final MessageType<Defaulted> TYPE = SCHEMA.build();

    @Override
    public MessageType<Defaulted> type() {
      return TYPE;
    }
  }

  /** {t, a} of a writer that leaves the default out, then {a, b}: as many pairs, a comes first. */
  @Test
  void decode_defaultLeftOutBefore_isReadWhereItIsThere() throws MalformedMessageException {
    MessageCodec reader = new MessageCodec(MessageTypes.of(List.of(Defaulted.TYPE)));
    byte[] without = HexFormat.of().parseHex("a2" + "61746161" + "6161fb4000000000000000");
    byte[] with =
        HexFormat.of().parseHex("a2" + "6161fb4000000000000000" + "6162fb4014000000000000");

    U2SAData old = reader.decode(Defaulted.TYPE.chain(), without);
    assertThat(old.get(Defaulted.WITH_DEFAULT)).hasValue(1.0);
    for (int time = 1; time <= 2; time++) {
      U2SAData message = reader.decode(Defaulted.TYPE.chain(), with);
      assertThat(message.get(Defaulted.NUMBER)).hasValue(2.0);
      assertThat(message.get(Defaulted.WITH_DEFAULT)).hasValue(5.0);
      assertThat(message.get(Defaulted.TEXT)).isNull();
    }
    assertThat(reader.decode(Defaulted.TYPE.chain(), without)).isEqualTo(old);
  }
}
