package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A file of the repository's prose, which a test checks, or writes again where it is generated. */
final class Page {
  /** The repository's root. */
  static final Path ROOT = Path.of("").toAbsolutePath().getParent();

  private static final boolean WRITE = Boolean.getBoolean("u2sa.docs.write");

  private final Path file;

  /**
   * @param name path from the repository's root
   */
  Page(String name) {
    file = ROOT.resolve(name);
  }

  String text() throws IOException {
    return Files.readString(file);
  }

  /** Fails unless the page is this text; with -Du2sa.docs.write=true writes it instead. */
  void mustBe(String expected) throws IOException {
    if (WRITE) {
      Files.writeString(file, expected);
    }
    assertThat(text())
        .as("%s is out of date; `%s` rewrites it", ROOT.relativize(file), command())
        .isEqualTo(expected);
  }

  /** What writes all generated pages again. */
  static String command() {
    return "mvn -q -pl u2sa-system-tests -am test -Dtest='org.u2sa.docs.*Test'"
        + " -Dsurefire.failIfNoSpecifiedTests=false -Du2sa.docs.write=true";
  }
}
