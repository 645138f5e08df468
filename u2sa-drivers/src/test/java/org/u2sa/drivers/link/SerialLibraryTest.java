package org.u2sa.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Where the native library of serial ports is loaded from. */
class SerialLibraryTest {
  private static final Set<PosixFilePermission> OWNERS =
      PosixFilePermissions.fromString("rwx------");

  @Test
  @EnabledOnOs(OS.LINUX)
  void open_serialPort_loadsALibraryThatOnlyThisAccountCanReplace() throws IOException {
    String temporary = System.getProperty("java.io.tmpdir");
    Port.Opener opener = new SerialOpener(new LinkAddress("serial:/dev/ttyABSENT"), false);

    assertThatThrownBy(opener::open)
        .isInstanceOf(IOException.class)
        .hasMessageContaining("does not exist");

    assertThat(System.getProperty("java.io.tmpdir")).isEqualTo(temporary);
    List<Path> loaded =
        Files.readAllLines(Path.of("/proc/self/maps")).stream()
            .filter(line -> line.contains("jSerialComm"))
            .map(line -> Path.of(line.substring(line.indexOf('/'))))
            .distinct()
            .toList();
    assertThat(loaded).isNotEmpty().allMatch(SerialLibraryTest::isUnderAPrivateFolder);
  }

  private static boolean isUnderAPrivateFolder(Path file) {
    for (Path folder = file.getParent(); folder != null; folder = folder.getParent()) {
      try {
        Set<PosixFilePermission> allowed = Files.getPosixFilePermissions(folder);
        if (OWNERS.containsAll(allowed)) {
          return true;
        }
      } catch (IOException e) {
        throw new AssertionError(folder.toString(), e);
      }
    }
    return false;
  }
}
