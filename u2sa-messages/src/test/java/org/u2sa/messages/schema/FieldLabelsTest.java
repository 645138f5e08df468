package org.u2sa.messages.schema;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.FieldLabels;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.registry.StandardTypes;

/** Numbers instead of names: which they are, and what becomes of those that a reader lacks. */
class FieldLabelsTest {
  private static final String UNKNOWN = "1903e8"; // 1000
  private final MessageCodec names = new MessageCodec(StandardTypes.registry());
  private final MessageCodec labels = new MessageCodec(StandardTypes.registry(), WireForm.COMPACT);

  private U2SAData decoded(String chain, String hex) throws MalformedMessageException {
    return names.decode(List.of(chain.split("/")), HexFormat.of().parseHex(hex.replace(" ", "")));
  }

  /**
   * What programs without our classes read them from. After a new field: -Du2sa.docs.write=true
   * appends its name; a line that was there never changes.
   */
  @Test
  void labels_all_areThoseOfTheList() throws IOException {
    Path file = Repository.file("docs/wire/labels.txt");
    List<String> written = new ArrayList<>();
    for (int label = 0; label < FieldLabels.count(); label++) {
      written.add(label + " " + FieldLabels.name(label));
    }
    assertThat(written).as("labels that were written once").startsWith(lines(file));
    if (Boolean.getBoolean("u2sa.docs.write")) {
      Files.write(file, (String.join("\n", written) + "\n").getBytes(UTF_8));
    }
    assertThat(lines(file)).isEqualTo(written.toArray());
  }

  private static String[] lines(Path file) throws IOException {
    return Files.readAllLines(file, UTF_8).toArray(new String[0]);
  }

  @Test
  void labels_all_haveNamesOfTheirOwn() {
    for (int label = 0; label < FieldLabels.count(); label++) {
      assertThat(FieldLabels.of(FieldLabels.name(label))).isEqualTo(label);
    }
  }

  /** A new field's name is appended to the list, or its messages are longer than they need be. */
  @Test
  void labels_everyStandardField_hasOne() {
    for (MessageType<?> type : StandardTypes.registry().all()) {
      for (MessageField<?> field : type.fields()) {
        assertThat(FieldLabels.of(field.name())).as(field.path()).isNotNull();
      }
    }
  }

  @Test
  void encode_commandWithLabels_isAsTheProtocolSays()
      throws IOException, MalformedMessageException {
    byte[] kept = Files.readAllBytes(Repository.file("docs/wire/labels.cbor"));
    U2SAData golden = GoldenMessages.all().get("PercentageCommand");

    assertThat(labels.encode(golden)).isEqualTo(kept);
    assertThat(names.decode(golden.typeChain(), kept)).isEqualTo(golden);
  }

  @Test
  void encode_everyGoldenMessage_isReadWithOriginAndShorter() throws MalformedMessageException {
    Origin origin = new Origin("1f0c", 17);
    for (Map.Entry<String, U2SAData> golden : GoldenMessages.all().entrySet()) {
      U2SAData message = golden.getValue();
      byte[] bytes = labels.encode(message, origin);

      U2SAData read = names.decode(message.typeChain(), bytes);

      assertThat(read).as(golden.getKey()).isEqualTo(message);
      assertThat(read.origin()).contains(origin);
      assertThat(bytes.length).isLessThan(names.encode(message, origin).length);
    }
  }

  @Test
  void decode_classUnknown_showsItsFieldsByNameAndRelaysThemInEitherForm()
      throws MalformedMessageException {
    PercentageCommand command = PercentageCommand.of("AILERON", -12.5);
    MessageCodec ignorant = new MessageCodec(MessageTypes.of(List.of()));

    U2SAData opaque = ignorant.decode(command.typeChain(), labels.encode(command));

    assertThat(opaque).isInstanceOf(OpaqueMessage.class);
    assertThat(opaque.unknownFields())
        .containsEntry("actuatorName", "AILERON")
        .containsEntry("percentage", -12.5);
    assertThat(names.decode(command.typeChain(), opaque.serialize())).isEqualTo(command);
    assertThat(labels.encode(opaque)).isEqualTo(labels.encode(command));
  }

  /** {1000: 1.5, 6: 2.5}: a field of a later version among x. */
  @Test
  void decode_labelUnknown_isSkippedAsAnUnknownNameIs() throws MalformedMessageException {
    U2SAData state =
        decoded("StateInformation", "a2 " + UNKNOWN + " fb3ff8000000000000 06 fb4004000000000000");
    assertThat(((StateInformation) state).x()).hasValue(2.5);
    assertThat(state.unknownFields()).isEmpty();
  }

  /** What an old relay makes of a label that it lacks, a newer reader understands. */
  @Test
  void decode_labelUnknownInAnUnknownClass_isKeptAsItsNumber() throws MalformedMessageException {
    U2SAData tide = decoded("Tide", "a1 " + UNKNOWN + " 07");

    assertThat(tide.unknownFields()).isEqualTo(Map.of("#1000", 7L));
    assertThat(names.decode(List.of("Tide"), tide.serialize())).isEqualTo(tide);
    U2SAData state = decoded("StateInformation", "a1 62 2336 fb4004000000000000"); // "#6"
    assertThat(((StateInformation) state).x()).hasValue(2.5);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a2 06 fb4004000000000000 06 fb4004000000000000 | the key occurs twice",
        "a2 06 fb4004000000000000 6178 fb4004000000000000 | the key occurs twice",
        "a2 6178 fb4004000000000000 06 fb4004000000000000 | the key occurs twice",
        "a2 6178 fb4004000000000000 622336 fb4004000000000000 | the key occurs twice",
        "a2 1903e8 01 1903e8 01 | the key occurs twice",
        "a1 06 6178 | StateInformation.x, byte 3: expected a number, not text",
        "a1 20 00 | expected text, not an integer",
        "a1 1bffffffffffffffff 00 | not a 65",
        "a1 1806 | expected a data item, not the end",
        "a2 1903e8 07 | StateInformation.#1000, byte 5: expected a data item, not the end",
        "a2 1903e8 07 18 | StateInformation.#1000, byte 6: expected more bytes, not the end",
      })
  void decode_malformedWithLabels_isRefusedWithWhatWasExpected(String hex, String expected) {
    assertThatThrownBy(() -> decoded("StateInformation", hex))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining(expected);
  }
}
