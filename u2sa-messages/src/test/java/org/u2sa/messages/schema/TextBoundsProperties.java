package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;

/** Texts of any length and content, set and read: names are refused, notes shortened. */
class TextBoundsProperties {
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  @Provide
  Arbitrary<String> anyChars() { // halves of surrogate pairs, too
    return Arbitraries.strings().all().ofMaxLength(3_000);
  }

  @Property(tries = 300)
  void note_anyText_isTakenAndKeepsItsBeginning(@ForAll("anyChars") String text)
      throws MalformedMessageException {
    EmergencyStop stop = new EmergencyStop().active(true).reason(text);

    assertThat(stop.reason().length()).isLessThanOrEqualTo(Limits.NOTE_CHARS);
    assertThat(StandardCharsets.UTF_8.newEncoder().canEncode(stop.reason())).isTrue();
    assertThat(codec.decode(EmergencyStop.TYPE.chain(), stop.serialize())).isEqualTo(stop);
    if (text.length() <= Limits.NOTE_CHARS && MessageArbitraries.isUnicode(text)) {
      assertThat(stop.reason()).isEqualTo(text);
    }
  }

  @Property(tries = 50)
  void notes_anyNumberOfAnyLength_fitIntoAMessage(
      @ForAll @IntRange(max = 400) int count, @ForAll @IntRange(max = 70_000) int length) {
    String text = "\uffe6".repeat(length); // three bytes each
    ArmingState state = new ArmingState().reasons(Collections.nCopies(count, text));

    assertThat(state.reasons()).hasSize(Math.min(count, Limits.NOTES));
    assertThat(state.serialize().length).isLessThan(Limits.PAYLOAD_BYTES / 2);
  }

  @Example
  void notes_moreThanFit_sayHowMany() {
    List<String> reasons = new ArmingState().reasons(Collections.nCopies(250, "x")).reasons();

    assertThat(reasons.get(98)).isEqualTo("x");
    assertThat(reasons.get(99)).isEqualTo("and 151 more");
  }

  @Property(tries = 100)
  void decode_textOfAnyLengthInANote_isShortened(@ForAll @IntRange(max = 65_536) int length)
      throws MalformedMessageException {
    byte[] bytes = ForeignReport.saying("a".repeat(length)).serialize();

    HealthReport read = (HealthReport) codec.decode(HealthReport.TYPE.chain(), bytes);

    assertThat(read.lastError().orElseThrow()).hasSize(Math.min(length, Limits.NOTE_CHARS));
  }

  @Property(tries = 100)
  void name_beyondItsBound_isRefusedWhenSetAndWhenRead(
      @ForAll @IntRange(min = 256, max = 65_536) int length) {
    String name = "n".repeat(length);
    byte[] bytes = ForeignState.named(name).serialize();

    assertThatThrownBy(() -> new StateInformation().sensorName(name))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(
            "StateInformation.sensorName: expected at most 255 characters, not " + length);
    assertThatThrownBy(() -> codec.decode(StateInformation.TYPE.chain(), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("StateInformation.sensorName, byte ")
        .hasMessageContaining("expected at most 255 characters");
  }

  @Property(tries = 100)
  void name_withinItsBound_isKept(@ForAll @IntRange(max = 255) int length)
      throws MalformedMessageException {
    StateInformation state = new StateInformation().sensorName("\uffe6".repeat(length));

    assertThat(codec.decode(StateInformation.TYPE.chain(), state.serialize())).isEqualTo(state);
  }

  /** A report of a program whose texts have no bound but the wire's. */
  private static final class ForeignReport extends U2SAData {
    private static final Schema<ForeignReport> SCHEMA =
        Schema.of("HealthReport", ForeignReport.class, ForeignReport::new, U2SAData.TYPE);
    private static final ValueField<ForeignReport, String> SERVICE =
        SCHEMA.requiredText("serviceName");
    private static final ValueField<ForeignReport, ServiceStatus> STATUS =
        SCHEMA.requiredChoice("status", ServiceStatus.class);
    private static final ValueField<ForeignReport, String> ERROR = SCHEMA.requiredText("lastError");
    private static final MessageType<ForeignReport> OWN_TYPE = SCHEMA.build();

    static ForeignReport saying(String error) {
      ForeignReport report = new ForeignReport();
      report.put(SERVICE, "Compass");
      report.put(STATUS, ServiceStatus.RUNNING);
      return report.put(ERROR, error);
    }

    @Override
    public MessageType<ForeignReport> type() {
      return OWN_TYPE;
    }
  }

  /** A state of such a program. */
  private static final class ForeignState extends U2SAData {
    private static final Schema<ForeignState> SCHEMA =
        Schema.of("StateInformation", ForeignState.class, ForeignState::new, U2SAData.TYPE);
    private static final ValueField<ForeignState, String> SENSOR =
        SCHEMA.requiredText("sensorName");
    private static final MessageType<ForeignState> OWN_TYPE = SCHEMA.build();

    static ForeignState named(String name) {
      return new ForeignState().put(SENSOR, name);
    }

    @Override
    public MessageType<ForeignState> type() {
      return OWN_TYPE;
    }
  }
}
