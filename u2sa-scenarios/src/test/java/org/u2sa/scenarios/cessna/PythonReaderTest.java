package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.Repository;

/**
 * The wire is readable without Java: scripts/wire/decode.py reads every golden vector with Python's
 * cbor2.
 */
class PythonReaderTest {
  private static final Path VECTORS = Repository.root().resolve("docs/wire/golden");

  @Test
  @NeedsProgram(value = "python3", modules = "cbor2")
  void decodePy_goldenVectors_readsThemAll() throws IOException, InterruptedException {
    ForeignProgram.Ended read =
        ForeignProgram.run(
            ForeignPrograms.ofThisMachine().required("python3", "cbor2"),
            Repository.root().resolve("scripts/wire/decode.py").toString());

    assertThat(read.output())
        .contains(vectors() + " golden vectors read with cbor2, 0 differences");
    assertThat(read.exit()).isZero();
  }

  private static long vectors() throws IOException {
    try (Stream<Path> files = Files.list(VECTORS)) {
      return files.filter(file -> file.toString().endsWith(".cbor")).count();
    }
  }
}
