package org.u2sa.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;

class ReportFileTest {

  @TempDir private Path directory;

  @Test
  void writeText_diskFullHalfWay_keepsTheOldFileAndNamesThePath() throws IOException {
    Path file = Files.writeString(directory.resolve("track.csv"), "old");
    assertThatThrownBy(
            () ->
                ReportFile.writeText(
                    file,
                    out -> {
                      out.write("half");
                      throw new IOException("No space left on device");
                    }))
        .isInstanceOf(RunFailedException.class)
        .hasMessage("cannot write " + file + ": No space left on device");
    assertThat(file).hasContent("old");
    assertThat(directory.toFile().list()).containsExactly("track.csv");
  }

  @Test
  void writeText_noDirectory_saysSo() {
    Path file = directory.resolve("gone/track.csv");
    assertThatThrownBy(() -> ReportFile.writeText(file, out -> out.write("x")))
        .hasMessage("cannot write " + file + ": its directory does not exist");
  }

  @Test
  void write_overARecording_isRefusedAndKeepsIt() throws IOException {
    byte[] recording = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n', 1, 2, 3};
    Path file = Files.write(directory.resolve("a.mcap"), recording);
    assertThatThrownBy(() -> ReportFile.writeText(file, out -> out.write("<html>")))
        .isInstanceOf(BadInputException.class)
        .hasMessage(file + " is a recording; expected another file to write to");
    assertThat(file).hasBinaryContent(recording);
  }

  @Test
  void write_overAShortFile_replacesIt() throws IOException {
    Path file = Files.write(directory.resolve("a.html"), new byte[] {(byte) 0x89, 'M'});
    ReportFile.writeText(file, out -> out.write("<html>"));
    assertThat(file).hasContent("<html>");
  }

  @Test
  void write_linkInPlaceOfTheTemporaryFile_itsTargetStays() throws IOException {
    Path target = Files.writeString(directory.resolve("kept"), "kept");
    Files.createSymbolicLink(directory.resolve(".map.svg.part"), target);
    ReportFile.writeText(directory.resolve("map.svg"), out -> out.write("map"));

    assertThat(target).hasContent("kept");
    assertThat(directory.resolve("map.svg")).hasContent("map");
  }
}
