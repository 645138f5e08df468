package org.u2sa.report.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.FilterWriter;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.RunFailedException;

class CsvFilesTest {
  private static final int FILES = 1_000;

  @TempDir Path folder;
  private int open;
  private int mostOpen;

  private Writer opened(Path file, OpenOption... how) throws IOException {
    open++;
    mostOpen = Math.max(mostOpen, open);
    return new FilterWriter(Files.newBufferedWriter(file, how)) {
      @Override
      public void close() throws IOException {
        open--;
        super.close();
      }
    };
  }

  @Test
  void write_manyFilesByTurns_fewAreOpenAndEachHasItsLinesInOrder() throws IOException {
    Files.writeString(folder.resolve("7"), "of an earlier export");
    try (CsvFiles files = new CsvFiles(this::opened)) {
      for (int line = 0; line < 3; line++) {
        for (int i = 0; i < FILES; i++) {
          files.write(folder.resolve("" + i), line + "\n");
        }
      }
    }
    assertThat(mostOpen).isBetween(2, 256);
    assertThat(open).isZero();
    for (int i = 0; i < FILES; i++) {
      assertThat(folder.resolve("" + i)).hasContent("0\n1\n2\n");
    }
  }

  /** In a shared folder the link may be somebody else's. */
  @Test
  void write_linkOfThatName_isReplacedAndItsTargetStays() throws IOException {
    Path target = Files.writeString(folder.resolve("kept"), "kept");
    Path file = Files.createSymbolicLink(folder.resolve("state.csv"), target);
    try (CsvFiles files = new CsvFiles()) {
      files.write(file, "1\n");
    }
    assertThat(target).hasContent("kept");
    assertThat(file).hasContent("1\n");
    assertThat(Files.isSymbolicLink(file)).isFalse();
  }

  @Test
  void close_diskFull_namesTheFile() {
    CsvFiles files =
        new CsvFiles(
            (file, how) ->
                new FilterWriter(Writer.nullWriter()) {
                  @Override
                  public void close() throws IOException {
                    throw new IOException("No space left on device");
                  }
                });
    files.write(folder.resolve("state.csv"), "1\n");
    assertThatThrownBy(files::close)
        .isInstanceOf(RunFailedException.class)
        .hasMessage("cannot write " + folder.resolve("state.csv") + ": No space left on device");
  }
}
