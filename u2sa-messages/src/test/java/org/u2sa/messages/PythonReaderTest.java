package org.u2sa.messages;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/**
 * The wire is readable without Java: scripts/wire/decode.py reads every golden vector with Python's
 * cbor2.
 */
class PythonReaderTest {
  private record Run(int exit, String output) {}

  @Test
  void decodePy_goldenVectors_readsThemAll() throws IOException, InterruptedException {
    boolean hasCbor2 = hasCbor2();
    if ("true".equals(System.getenv("CI"))) {
      assertThat(hasCbor2).as("CI needs python3 with cbor2: pip install cbor2").isTrue();
    }
    assumeTrue(hasCbor2, "python3 with cbor2 is not here: pip install cbor2 to run this test");

    Run run = run("python3", Repository.file("scripts/wire/decode.py").toString());

    assertThat(run.output())
        .contains(GoldenMessages.all().size() + " golden vectors read with cbor2, 0 differences");
    assertThat(run.exit()).isZero();
  }

  private static boolean hasCbor2() throws InterruptedException {
    try {
      return run("python3", "-c", "import cbor2").exit() == 0;
    } catch (IOException e) {
      return false; // no python3
    }
  }

  private static Run run(String... command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String output = new String(process.getInputStream().readAllBytes(), UTF_8);
    return new Run(process.waitFor(), output);
  }
}
