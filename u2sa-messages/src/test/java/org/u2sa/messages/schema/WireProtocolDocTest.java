package org.u2sa.messages.schema;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/**
 * Holds the example of docs/wire-protocol.md to its golden vector. To write it again:
 * -Du2sa.docs.write=true.
 */
class WireProtocolDocTest {
  private static final String EXAMPLE = "<!-- example: written by WireProtocolDocTest -->\n";
  private static final String END_OF_EXAMPLE = "<!-- end of example -->";

  @Test
  void example_bytesWithNotes_areTheGoldenOnes() throws IOException {
    byte[] bytes = Files.readAllBytes(Repository.file("docs/wire/golden/PercentageCommand.cbor"));
    assertWritten(EXAMPLE, END_OF_EXAMPLE, AnnotatedHex.of(bytes));
  }

  private static void assertWritten(String begin, String end, String expected) throws IOException {
    Path file = Repository.file("docs/wire-protocol.md");
    String doc = new String(Files.readAllBytes(file), UTF_8);
    int from = doc.indexOf(begin) + begin.length();
    if (Boolean.getBoolean("u2sa.docs.write")) {
      doc = doc.substring(0, from) + expected + doc.substring(doc.indexOf(end));
      Files.write(file, doc.getBytes(UTF_8));
    }
    assertThat(doc.substring(from, doc.indexOf(end))).isEqualTo(expected);
  }
}
