package org.u2sa.messages.schema;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The golden vectors of every released format stand as they were released; scripts/wire/freeze adds
 * a format, and says what to write here.
 */
class GoldenManifestTest {
  private static final Path FOLDER = Repository.file("docs/wire/golden");

  /**
   * Each released format's list of vectors and its sources. A line here is written once, at the
   * release, and never changed: whoever does breaks those who have that release.
   */
  private static final Map<String, String> RELEASED =
      Map.of(
          "format-1.sha256", "ca28bbd458bf45b247ac4707c4678623b36fc986f5faf5fdfa78f4423fe0d54f",
          "format-1.zip", "8b0096c3cfbd40dedc53a779b73f3c8845db59e60ecfdb03d6274bc487fd0d84",
          "format-2.sha256", "1d6c29438dec7b9166ef38d2a0aa01a690e249007a185b4cfc7e5b68f065dc29",
          "format-2.zip", "0822c6e50df334efa73f64b28192fcfe37e81b30af5576c66c27ec420c8dd5e8");

  /** File names of all frozen formats with their SHA-256. */
  private static Map<String, String> frozen() throws IOException {
    Map<String, String> frozen = new LinkedHashMap<>();
    try (Stream<Path> files = Files.list(FOLDER)) {
      for (Path manifest :
          files.filter(file -> file.toString().endsWith(".sha256")).sorted().toList()) {
        for (String line : Files.readAllLines(manifest, UTF_8)) {
          String[] parts = line.split("  ", 2);
          assertThat(frozen.put(parts[1], parts[0])).as("%s is in two formats", line).isNull();
        }
      }
    }
    return frozen;
  }

  @Test
  void formats_released_areThoseOfThisTest() throws IOException, NoSuchAlgorithmException {
    Map<String, String> found = new TreeMap<>();
    for (Path folder : List.of(FOLDER, OldDataModel.sources(1).getParent())) {
      try (Stream<Path> files = Files.list(folder)) {
        for (Path file :
            files.filter(each -> each.getFileName().toString().startsWith("format-")).toList()) {
          found.put(file.getFileName().toString(), sha256(file));
        }
      }
    }

    assertThat(found).containsExactlyInAnyOrderEntriesOf(RELEASED);
  }

  @Test
  void frozenVectors_ofEveryFormat_areAsReleased() throws IOException, NoSuchAlgorithmException {
    List<String> wrong = new ArrayList<>();
    for (Map.Entry<String, String> entry : frozen().entrySet()) {
      Path file = FOLDER.resolve(entry.getKey());
      if (!Files.exists(file) || !sha256(file).equals(entry.getValue())) {
        wrong.add(entry.getKey());
      }
    }

    assertThat(wrong).as("golden vectors of a released format that changed or are gone").isEmpty();
  }

  @Test
  void frozenVectors_ofEveryFormat_areStillWrittenByTheCode() throws IOException {
    for (String file : frozen().keySet()) {
      if (file.endsWith(".cbor")) {
        assertThat(GoldenMessages.all()).containsKey(file.substring(0, file.length() - 5));
      }
    }
    assertThat(frozen()).hasSizeGreaterThanOrEqualTo(66);
  }

  @Test
  void frozenVectors_ofFormat1_haveNoFieldOfALaterOne() throws IOException {
    Map<String, U2SAData> golden = GoldenMessages.all();
    for (String line : Files.readAllLines(FOLDER.resolve("format-1.sha256"), UTF_8)) {
      String name = line.split("  ", 2)[1];
      if (name.endsWith(".cbor")) {
        U2SAData message = golden.get(name.substring(0, name.length() - 5));
        for (MessageField<U2SAData> field : message.ownType().fields()) {
          assertThat(field.since() > 1 && field.isSet(message)).as(name + " " + field).isFalse();
        }
      }
    }
  }

  private static String sha256(Path file) throws IOException, NoSuchAlgorithmException {
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file));
    return HexFormat.of().formatHex(digest);
  }
}
