package org.u2sa.interfaces.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

/** Files that never end, never begin, or are larger than memory. */
@Timeout(60)
class XmlLimitsTest {
  @TempDir Path folder;

  private static void assertRefused(Path file, String reason) {
    assertThatThrownBy(() -> XmlReader.read(file, "mission"))
        .isInstanceOf(BadInputException.class)
        .hasMessage(file + reason);
  }

  private static void assertRefused(String text, String reason) {
    InputStream in = new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
    assertThatThrownBy(() -> XmlReader.read(in, "m.xml", "mission"))
        .isInstanceOf(BadInputException.class)
        .hasMessageMatching(reason);
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void read_device_isRefusedUnread() {
    assertRefused(Paths.get("/dev/zero"), ": is a device or similar, expected a regular file");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void read_linkToADevice_isRefusedUnread() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("m.xml"), Paths.get("/dev/zero"));
    assertRefused(link, ": is a device or similar, expected a regular file");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void read_namedPipe_isRefusedWithoutWaitingForAWriter() throws Exception {
    Path pipe = folder.resolve("pipe.xml");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    assertRefused(pipe, ": is a device or similar, expected a regular file");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void read_linkToAKernelFileWithoutSize_isRefusedUnread() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("m.xml"), Paths.get("/proc/kmsg"));
    assertRefused(
        link, ": is empty, expected an XML file"); // its reader waits for ever, or may not
  }

  @Test
  void read_directory_isRefused() {
    assertRefused(folder, ": is a directory, expected an XML file");
  }

  @Test
  void read_missingFile_isRefused() {
    assertRefused(folder.resolve("none.xml"), ": there is no such file");
  }

  @Test
  void read_linkThatPointsAtItself_isRefused() throws IOException {
    Path loop = folder.resolve("loop.xml");
    Files.createSymbolicLink(loop, loop.getFileName());
    assertThatThrownBy(() -> XmlReader.read(loop, "mission"))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith(loop.toString());
  }

  @Test
  void read_hugeFile_isRefusedWithTheLimit() throws IOException {
    Path file = folder.resolve("huge.xml");
    try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
      sparse.setLength(1L << 40);
    }
    assertRefused(file, ": is larger than 16 MB, the maximum");
  }

  @Test
  void read_streamWithoutEnd_isRefusedWithTheLimit() {
    InputStream endless =
        new InputStream() {
          @Override
          public int read() {
            return ' ';
          }
        };
    assertThatThrownBy(() -> XmlReader.read(endless, "m.xml", "mission"))
        .hasMessage("m.xml: is larger than 16 MB, the maximum");
  }

  @Test
  void read_elementsWithinEachOther_areRefusedInTheirLine() {
    assertRefused(
        "<mission>\n" + "<a>".repeat(4_000_000), "m\\.xml, line 2: more than 100 nested elements");
  }

  @Test
  void read_millionsOfElements_areRefused() {
    assertRefused(
        "<mission>\n" + "<a/>".repeat(3_000_000) + "</mission>",
        "m\\.xml, line 2: more than 1000000 elements");
  }

  @Test
  void read_hugeAttribute_isRefused() {
    assertRefused(
        "<mission>\n<a b='" + "x".repeat(10_000_000) + "'/></mission>",
        "m\\.xml, line 2: not well-formed XML: Maximum attribute size limit .*");
  }

  @Test
  void read_manyAttributes_areRefused() {
    StringBuilder text = new StringBuilder("<mission>\n<a");
    for (int i = 0; i < 100_000; i++) {
      text.append(" b").append(i).append("='1'");
    }
    assertRefused(
        text + "/></mission>",
        "m\\.xml, line 2: not well-formed XML: Attribute limit \\(100\\) exceeded");
  }

  @Test
  void read_longName_isRefused() {
    assertRefused(
        "<mission>\n<" + "n".repeat(5_000_000) + "/></mission>",
        "m\\.xml, line 2: the name \"n{40}…\" is longer than 200 characters");
  }
}
