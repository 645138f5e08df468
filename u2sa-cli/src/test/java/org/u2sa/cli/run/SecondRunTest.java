package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.UUID;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.gcs.remote.LocalSystems;
import org.u2sa.testkit.FreePort;

@SuppressWarnings("try") // announcements are there to be ended, not called
class SecondRunTest extends CommandFixture {
  @TempDir private Path folder;
  private final String system = "rover-" + UUID.randomUUID();

  private Path file() throws IOException {
    return Files.writeString(
        folder.resolve("system.xml"),
        "<system id=\"" + system + "\"><service class=\"org.example.None\"/></system>");
  }

  private LocalSystems.Announcement runningAt(int port) {
    return LocalSystems.ofAccount()
        .announce(system, Optional.of(new InetSocketAddress("127.0.0.1", port)), line -> {});
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void run_vehicleThatRunsAtAnotherPort_isRefused(boolean withPort) throws IOException {
    int port = FreePort.find();
    String setting = "CommunicationManager:COMMUNICATION MANAGER PORT=" + FreePort.find();
    try (LocalSystems.Announcement first = runningAt(port)) {
      String[] line = {"run", file().toString(), "--set", setting};
      assertThat(withPort ? u2sa(line) : u2sa(line[0], line[1])).isEqualTo(ExitCode.BAD_INPUT);
    }
    assertThat(err.toString())
        .contains(system + " at localhost:" + port + " is already running on this machine");
  }

  @Test
  void run_vehicleThatRunsAtTheConfiguredPort_isRefusedAsRunning() throws IOException {
    int port = FreePort.find();
    String setting = "CommunicationManager:COMMUNICATION MANAGER PORT=" + port;
    try (LocalSystems.Announcement first = runningAt(port)) {
      assertThat(u2sa("run", file().toString(), "--set", setting)).isEqualTo(ExitCode.BAD_INPUT);
    }
    assertThat(err.toString()).contains("is already running on this machine; end it first");
  }
}
