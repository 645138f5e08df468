package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;

/** Where system files have the operator's page and rosbridge served. */
class SystemFileWebTest {
  @TempDir private Path directory;

  private SystemFile read(String web) throws IOException {
    Path file = directory.resolve("system.xml");
    Files.writeString(
        file,
        "<system id=\"boat\">\n" + web + "\n<service class=\"org.example.Boat\"/>\n</system>");
    return SystemFile.read(file);
  }

  @Test
  void read_webElement_hasItsPortOr8080AndKeepsItInCopies() throws IOException {
    assertThat(read("<web port='8443'/>").webPort()).isEqualTo(OptionalInt.of(8443));
    assertThat(read("<web/>").withoutServices().webPort()).isEqualTo(OptionalInt.of(8080));
    assertThat(read("").webPort()).isEmpty();
  }

  @Test
  void read_rosbridgeElement_hasItsPortOr9090AndKeepsItInCopies() throws IOException {
    assertThat(read("<rosbridge port='9091'/>").rosbridgePort()).isEqualTo(OptionalInt.of(9091));
    assertThat(read("<rosbridge/>").withoutServices().rosbridgePort())
        .isEqualTo(OptionalInt.of(9090));
    assertThat(read("<web/>").rosbridgePort()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "65536", "-1", "http", ""})
  void read_wrongPort_isRefusedWithFileAndLine(String port) {
    assertThatThrownBy(() -> read("<web port='" + port + "'/>"))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            directory.resolve("system.xml")
                + ", line 2, <web>: port \""
                + port
                + "\": expected 1…65535");
  }
}
