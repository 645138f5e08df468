package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ConfigurationWritingTest {
  private static final String TWO =
      "<configuration>\n"
          + "  <variable name=\"A\" type=\"int\" value=\"%s\"/>\n"
          + "  <variable name=\"B\" type=\"string\" value=\"%s\"/>\n"
          + "</configuration>\n";

  @TempDir Path folder;
  private Path file;
  private XmlConfiguration configuration;

  @BeforeEach
  void load() throws IOException {
    file = write("X.xml", two(1, "x"));
    configuration = XmlConfiguration.load(file);
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.write(file, text.getBytes(StandardCharsets.UTF_8));
    return file;
  }

  private static String text(Path file) throws IOException {
    return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
  }

  private static String two(Object a, Object b) {
    return String.format(TWO, a, b);
  }

  @Test
  void setVariable_otherChangedTheFileMeanwhile_bothChangesStand() throws IOException {
    write("X.xml", "<!-- by hand -->" + two(1, "by hand"));

    assertThat(configuration.setVariable("A", 2)).isTrue();

    assertThat(text(file)).isEqualTo("<!-- by hand -->" + two(2, "by hand"));
    assertThat(configuration.getVariable("B")).isEqualTo("x");
  }

  @Test
  void setVariable_changesGoToACopy_theFileStaysAndTheCopyIsReadNext() throws IOException {
    Path copy = folder.resolve("run/changed/X.xml");
    configuration = XmlConfiguration.load(file, copy);
    assertThat(copy.getParent()).doesNotExist();

    assertThat(configuration.setVariable("A", 2)).isTrue();

    assertThat(text(file)).isEqualTo(two(1, "x"));
    assertThat(text(copy)).isEqualTo(two(2, "x"));
    assertThat(XmlConfiguration.load(file, copy).getVariable("A")).isEqualTo(2);
    assertThat(configuration.resolve("other.xml")).isEqualTo(folder.resolve("other.xml"));
    try (Stream<Path> beside = Files.list(folder)) {
      assertThat(beside).containsExactlyInAnyOrder(file, folder.resolve("run")); // no audit log
    }
  }

  @Test
  void setVariable_otherNarrowedTheRangeMeanwhile_isRefused() throws IOException {
    String narrowed = two(1, "x").replace("value=\"1\"", "value=\"1\" max=\"5\"");
    write("X.xml", narrowed);

    assertThat(configuration.change("A", 6))
        .contains(file + ", line 2, variable \"A\": 6 is not at most 5");

    assertThat(text(file)).isEqualTo(narrowed);
    assertThat(configuration.getVariable("A")).isEqualTo(1);
  }

  @Test
  void setVariable_otherIsInTheMiddleOfAnEdit_isRefused() throws IOException {
    write("X.xml", "<configuration>\n<variable nam");

    assertThat(configuration.change("A", 2).get())
        .startsWith(file + ", line 2: not well-formed XML: ");

    assertThat(text(file)).isEqualTo("<configuration>\n<variable nam");
    assertThat(configuration.getVariable("A")).isEqualTo(1);
  }

  @Test
  void setVariable_fileGone_isRefused() throws IOException {
    Files.delete(file);

    assertThat(configuration.change("A", 2)).contains(file + ": there is no such file");
    assertThat(configuration.getVariable("A")).isEqualTo(1);
    assertThat(file).doesNotExist();
  }

  @Test
  void setVariable_cannotBeWritten_oldFileAndValueStay() throws IOException {
    // The temporary file's name would be longer than file systems take; holds for root, too.
    file = write("x".repeat(230) + ".xml", two(1, "x"));
    configuration = XmlConfiguration.load(file);

    assertThat(configuration.setVariable("A", 2)).isFalse();
    assertThat(configuration.change("A", 2).get())
        .startsWith(file + ", variable \"A\": cannot be written, the old value stays: ")
        .endsWith("File name too long");

    assertThat(text(file)).isEqualTo(two(1, "x"));
    assertThat(configuration.getVariable("A")).isEqualTo(1);
    String own = file.getFileName().toString();
    assertThat(folder.toFile().list())
        .containsExactlyInAnyOrder("X.xml", own, own + ".audit.jsonl", ".configuration.lock");
    assertThat(configuration.revision()).isZero();
  }

  @Test
  void setVariable_refusedValues_giveTheReasonAndChangeNothing() throws IOException {

    assertThat(configuration.change("A", "abc"))
        .contains(
            file
                + ", line 2, variable \"A\": \"abc\" is not a whole number from -2147483648 to"
                + " 2147483647");
    assertThat(configuration.change("A", 1.5).get()).contains("1.5 is not a whole number");
    assertThat(configuration.change("C", 1)).contains(file + ", variable \"C\": not found");
    assertThat(configuration.change("B", "a\u0001"))
        .contains(file + ", variable \"B\": character U+0001 at position 2 is not allowed in XML");
    assertThat(text(file)).isEqualTo(two(1, "x"));
    assertThat(configuration.enumerateFields()).extracting("value").containsExactly(1, "x");
  }

  @Test
  void setVariable_twoThreads_noChangeIsLost() throws Exception {
    file = write("X.xml", two(0, "0"));
    configuration = XmlConfiguration.load(file);
    List<Callable<Boolean>> writers = new ArrayList<>();
    writers.add(() -> setUpTo(configuration, "A", 50));
    writers.add(() -> setUpTo(configuration, "B", 50));
    ExecutorService threads = Executors.newFixedThreadPool(2);
    try {
      for (Future<Boolean> done : threads.invokeAll(writers)) {
        assertThat(done.get()).isTrue();
      }
    } finally {
      threads.shutdownNow();
    }

    assertThat(text(file)).isEqualTo(two(50, 50));
  }

  private static boolean setUpTo(XmlConfiguration configuration, String name, int last) {
    boolean all = true;
    for (int i = 1; i <= last; i++) {
      all &= configuration.setVariable(name, String.valueOf(i));
    }
    return all;
  }

  @Test
  void setVariable_interruptedThread_writesAndStaysInterrupted() throws IOException {
    Thread.currentThread().interrupt();

    boolean set = configuration.setVariable("A", 2);

    assertThat(Thread.interrupted()).isTrue();
    assertThat(set).isTrue();
    assertThat(text(file)).isEqualTo(two(2, "x"));
  }

  @Test
  void setVariable_linkedFile_linkAndPermissionsStay() throws IOException {
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));
    Path link = Files.createSymbolicLink(folder.resolve("link.xml"), file);

    assertThat(XmlConfiguration.load(link).setVariable("A", 2)).isTrue();

    assertThat(link).isSymbolicLink();
    assertThat(text(file)).isEqualTo(two(2, "x"));
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-r--r--");
  }

  @Test
  void setVariable_leftoverOfAPowerCut_isDeleted() throws IOException {
    Path leftover = write(".X.xml.1.tmp", "<conf");
    Path others = write(".Y.xml.1.tmp", "<conf");

    assertThat(XmlConfiguration.load(file).setVariable("A", 2)).isTrue();

    assertThat(leftover).doesNotExist();
    assertThat(others).exists();
  }

  @Test
  void setVariable_fileInAnotherUnit_isWrittenInThatUnit() throws IOException {
    file =
        write(
            "X.xml",
            "<configuration><variable unit='ft' name='Z' type='double' value='10'/></configuration>");
    configuration = XmlConfiguration.load(file);
    assertThat(configuration.getVariable(VariableDeclaration.number("Z", "m"))).isEqualTo(3.048);

    assertThat(configuration.setVariable("Z", 6.096)).isTrue();

    assertThat(text(file)).contains("value='20.0'");
    assertThat(configuration.getVariable("Z")).isEqualTo(6.096);
  }

  @Test
  void setVariable_otherEncoding_isKept() throws IOException {
    String text =
        "<?xml version='1.0' encoding='ISO-8859-1'?>\n"
            + "<configuration><!-- é --><variable name='B' type='string' value='%s'/></configuration>";
    Files.write(file, String.format(text, "é").getBytes(StandardCharsets.ISO_8859_1));
    configuration = XmlConfiguration.load(file);

    assertThat(configuration.setVariable("B", "ü→'")).isTrue();

    assertThat(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1))
        .isEqualTo(String.format(text, "ü&#8594;&apos;"));
    assertThat(XmlConfiguration.load(file).getVariable("B")).isEqualTo("ü→'");
  }
}
