package org.u2sa.messages.schema;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.registry.StandardTypes;

/**
 * The bytes of the wire, kept: what was written once must be written and read for ever. After
 * adding a message to {@link GoldenMessages}, run with -Du2sa.golden.write=true and look at the
 * difference: old files must not change.
 */
class GoldenVectorsTest {
  private static final Path FOLDER = Repository.file("docs/wire/golden");
  private static final boolean WRITE = Boolean.getBoolean("u2sa.golden.write");

  static Stream<Map.Entry<String, U2SAData>> golden() {
    return GoldenMessages.all().entrySet().stream();
  }

  @ParameterizedTest
  @MethodSource("golden")
  void serialize_goldenMessage_givesTheKeptBytes(Map.Entry<String, U2SAData> golden)
      throws IOException {
    Path cbor = FOLDER.resolve(golden.getKey() + ".cbor");
    Path json = FOLDER.resolve(golden.getKey() + ".json");
    if (WRITE) {
      Files.write(cbor, golden.getValue().serialize());
      Files.write(json, PlainJson.of(golden.getValue()).getBytes(UTF_8));
    }

    assertThat(golden.getValue().serialize()).isEqualTo(Files.readAllBytes(cbor));
    assertThat(PlainJson.of(golden.getValue()))
        .isEqualTo(new String(Files.readAllBytes(json), UTF_8));
  }

  @ParameterizedTest
  @MethodSource("golden")
  void decode_keptBytes_givesTheGoldenMessage(Map.Entry<String, U2SAData> golden)
      throws IOException, MalformedMessageException {
    byte[] bytes = Files.readAllBytes(FOLDER.resolve(golden.getKey() + ".cbor"));

    U2SAData read =
        new MessageCodec(StandardTypes.registry()).decode(golden.getValue().typeChain(), bytes);

    assertThat(read).isEqualTo(golden.getValue());
  }

  @Test
  void golden_everyConcreteType_hasAVector() {
    Set<MessageType<?>> covered = new LinkedHashSet<>();
    GoldenMessages.all().values().forEach(message -> covered.add(message.type()));

    assertThat(covered).containsAll(MessageArbitraries.concreteTypes());
  }

  @Test
  void golden_everyField_isSetInSomeVector() {
    Set<String> missing = new LinkedHashSet<>();
    MessageArbitraries.concreteTypes()
        .forEach(type -> type.fields().forEach(field -> missing.add(field.path())));
    GoldenMessages.all().values().forEach(message -> removeSet(missing, message));

    assertThat(missing).as("fields that no golden vector sets").isEmpty();
  }

  private static void removeSet(Set<String> missing, U2SAData message) {
    for (MessageField<U2SAData> field : message.ownType().fields()) {
      if (field.isSet(message)) {
        missing.remove(field.path());
      }
    }
  }

  @Test
  void golden_everyFile_hasItsMessage() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      assertThat(
              files
                  .map(file -> file.getFileName().toString())
                  .filter(name -> !name.endsWith(".sha256")) // manifests of released formats
                  .map(name -> name.replaceAll("\\.[a-z]+$", "")))
          .allMatch(GoldenMessages.all()::containsKey);
    }
  }
}
