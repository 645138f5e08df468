package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

/** Links to MAVLink stations in system files. */
class MavlinkEntryTest {
  @TempDir private Path directory;

  private List<String> links(String elements) throws IOException {
    Path file = directory.resolve("system.xml");
    Files.writeString(
        file, "<system id=\"boat\">" + elements + "<service class=\"org.example.Boat\"/></system>");
    return SystemFile.read(file).mavlink().stream()
        .map(MavlinkEntry::link)
        .collect(Collectors.toList());
  }

  @Test
  void read_elements_areLinksWithOptions() throws IOException {
    assertThat(links("")).isEmpty();
    assertThat(links("<mavlink/>")).containsExactly("udp:127.0.0.1:14550");
    assertThat(
            links(
                "<mavlink link='tcp:5760' as='ardupilot' id='2' key='key.txt' logs='logs'/><mavlink/>"))
        .containsExactly(
            "tcp:5760,as=ardupilot,id=2,key="
                + directory.resolve("key.txt")
                + ",logs="
                + directory.resolve("logs"),
            "udp:127.0.0.1:14550");
  }

  @Test
  void read_unknownAttribute_isRefused() {
    assertThatThrownBy(() -> links("<mavlink port='5760'/>"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("port");
  }
}
