package org.u2sa.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.messages.schema.MessageTypes;

class ProviderFaultTest {
  private static final String KIND = MessageTypeProvider.class.getName();

  @TempDir private Path folder;
  private final StringWriter err = new StringWriter();

  /** What a command answers that looks for message types, with a jar that lists this. */
  private int answer(String list) throws IOException {
    Path file = folder.resolve("META-INF/services").resolve(KIND);
    Files.createDirectories(file.getParent());
    Files.writeString(file, list);
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before)) {
      thread.setContextClassLoader(loader);
      Throwable thrown = catchThrowable(MessageTypes::discovered);
      return new ErrorAnswers(() -> false)
          .answer(
              new IllegalStateException("a service failed", thrown), new PrintWriter(err, true));
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "org.example.SoilProbProvider, not found",
    "org.u2sa.cli.ProviderFaultTest, not a subtype",
  })
  void answer_listedClassThatIsNoProvider_namesFileLineAndExpectation(String name, String why)
      throws IOException {
    assertThat(answer("# of this project\n" + name + " # probe\n")).isEqualTo(ExitCode.BAD_INPUT);

    assertThat(err.toString())
        .startsWith("u2sa: " + folder)
        .contains(KIND + ", line 2: provider " + name + " " + why)
        .contains("; expected the full name of a public class that implements " + KIND)
        .doesNotContain("unexpected", "--debug");
  }

  @Test
  void answer_listThatIsNoList_namesFileAndLine() throws IOException {
    assertThat(answer("org.example.A B\n")).isEqualTo(ExitCode.BAD_INPUT);

    assertThat(err.toString()).contains(folder.toString(), KIND + ":1: ").doesNotContain("--debug");
  }
}
