package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** Tests of what is said about a configuration file. Whole messages: they are what a user gets. */
abstract class RefusedFile {
  @TempDir Path folder;
  Path file;

  @BeforeEach
  void name() {
    file = folder.resolve("Control.xml");
  }

  void write(String text) {
    try {
      Files.write(file, text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  XmlConfiguration configuration(String variables) {
    write("<configuration>\n" + variables + "\n</configuration>\n");
    return XmlConfiguration.load(file);
  }

  void assertRefused(ThrowingCallable call, String afterTheFile) {
    assertThatExceptionOfType(ConfigurationException.class)
        .isThrownBy(call)
        .withMessage(file + afterTheFile);
  }
}
