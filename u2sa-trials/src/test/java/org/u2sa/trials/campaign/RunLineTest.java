package org.u2sa.trials.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.ProtocolException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RunLineTest {
  private static final int FILE_BYTES = 100_000;

  @TempDir private Path folder;

  private static byte[] archive(String name, int bytes) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(out)) {
      zip.putNextEntry(new ZipEntry(name));
      zip.write(new byte[bytes]);
    }
    return out.toByteArray();
  }

  @Test
  void answer_answered_isTheSameWithItsFiles() throws IOException {
    RunAnswer answer = new RunAnswer(1, "{}", "said \"so\"");

    String line = RunLine.answered(answer, archive("logs/a.log", FILE_BYTES));

    assertThat(RunLine.answer(line, folder)).isEqualTo(answer);
    assertThat(folder.resolve("logs/a.log")).hasSize(FILE_BYTES);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "\u0000\u0001",
        "{",
        "{\"exit\":0}",
        "{\"exit\":\"many\",\"output\":\"\",\"errors\":\"\",\"files\":\"\"}",
        "{\"exit\":99999999999,\"output\":\"\",\"errors\":\"\",\"files\":\"\"}",
        "{\"exit\":0,\"output\":\"\",\"errors\":\"\",\"files\":\"!!\"}",
        "{\"exit\":[0,1],\"output\":\"\",\"errors\":\"\",\"files\":\"\"}"
      })
  void answer_malformedLine_isAProtocolError(String line) {
    assertThatThrownBy(() -> RunLine.answer(line, folder)).isInstanceOf(ProtocolException.class);
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void answer_mutatedLines_areAnswersOrProtocolErrors() throws IOException {
    String line = RunLine.answered(new RunAnswer(0, "{}", ""), archive("a", FILE_BYTES));
    Random random = new Random(1);
    for (int i = 0; i < 2_000; i++) {
      StringBuilder mutated = new StringBuilder(line);
      mutated.setCharAt(random.nextInt(line.length()), (char) (' ' + random.nextInt(95)));
      try {
        RunLine.answer(mutated.toString(), folder);
      } catch (ProtocolException e) {
        assertThat(e.getMessage()).isNotBlank();
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"../beside", "/tmp/u2sa-beside", "a/../../beside"})
  void answer_fileOutsideTheFolder_isAProtocolErrorAndNotWritten(String name) throws IOException {
    Path inner = Files.createDirectory(folder.resolve("inner"));
    String line = RunLine.answered(new RunAnswer(0, "", ""), archive(name, 1));

    assertThatThrownBy(() -> RunLine.answer(line, inner))
        .isInstanceOf(ProtocolException.class)
        .hasMessageContaining(name);
    assertThat(Files.list(folder).toList()).isEqualTo(List.of(inner));
  }

  @Test
  void unpack_moreThanTheLimit_isAProtocolError() throws IOException {
    byte[] packed = archive("zeros", FILE_BYTES);

    FolderArchive.unpack(packed, folder, FILE_BYTES);
    assertThatThrownBy(() -> FolderArchive.unpack(packed, folder, FILE_BYTES - 1))
        .isInstanceOf(ProtocolException.class)
        .hasMessageContaining("zeros");
  }
}
