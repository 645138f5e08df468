package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

class SystemFileHostsTest {
  @TempDir private Path folder;
  private Path file;

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("system.xml");
    Files.writeString(
        file,
        """
        <system id="boat">
          <communication host="bridge"/>
          <service class="a.Lidar" host="bow"/>
          <service class="a.Planner" host="bridge"/>
          <service class="a.Control" host="bow"/>
        </system>
        """);
  }

  private static List<String> names(SystemFile system) {
    return system.services().stream().map(SystemFile.Entry::simpleName).toList();
  }

  @Test
  void onHost_givesItsServicesInOrder() {
    SystemFile system = SystemFile.read(file);

    assertThat(names(system.onHost("bow"))).containsExactly("Lidar", "Control");
    assertThat(names(system.onHost("bridge"))).containsExactly("Planner");
    assertThat(system.communicationHost()).isEqualTo("bridge");
  }

  @Test
  void onHost_unknown_listsThoseNamed() {
    SystemFile system = SystemFile.read(file);

    assertThatThrownBy(() -> system.onHost("stern"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("names no host \"stern\"; expected one of [bow, bridge]");
  }

  @Test
  void onHost_serviceWithoutHost_saysWhereItIsMissing() throws IOException {
    Files.writeString(
        file, Files.readString(file).replace("class=\"a.Control\" host=\"bow\"", "class=\"a.B\""));
    SystemFile system = SystemFile.read(file);

    assertThatThrownBy(() -> system.onHost("bow"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("line 5")
        .hasMessageContaining("names no host");
  }

  @Test
  void only_several_keepsTheOrderOfTheFile() {
    assertThat(names(SystemFile.read(file).only(List.of("Control", "Lidar"))))
        .containsExactly("Lidar", "Control");
  }

  @Test
  void apart_twoOfOneName_isRefusedByLine() throws IOException {
    Path twice =
        Files.writeString(
            file.resolveSibling("twice.xml"),
            "<system id=\"boat\">\n<service class=\"a.Lidar\"/>\n<service class=\"b.Lidar\"/>\n"
                + "<service class=\"Control\"/></system>");
    SystemFile system = SystemFile.read(twice);

    assertThatThrownBy(system::apart)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("twice.xml, line 3")
        .hasMessageContaining("one more service \"Lidar\"");
    assertThat(names(system.only("Control"))).containsExactly("Control");
  }

  @Test
  void only_unknown_listsThoseKnown() {
    SystemFile system = SystemFile.read(file);

    assertThatThrownBy(() -> system.only(List.of("Lidar", "Sonar")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("no service \"Sonar\"; expected one of [Lidar, Planner, Control]");
  }
}
