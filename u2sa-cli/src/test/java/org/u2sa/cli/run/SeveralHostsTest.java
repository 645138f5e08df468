package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;
import org.u2sa.testkit.FreePort;

/** One system file, run in parts: as on several hosts. */
@Timeout(180)
class SeveralHostsTest extends CommandFixture {
  @TempDir private Path folder;
  private final int port = FreePort.find();
  private final String system = "boat-" + UUID.randomUUID(); // mDNS is everybody's
  private Path file;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(
        folder.resolve("Manager.xml"),
        """
        <configuration>
          <variable name="COMMUNICATION MANAGER PORT" type="int" value="%d"/>
          <variable name="COMMUNICATION MANAGER WAIT" type="double" value="90.0"/>
          <variable name="ANNOUNCE" type="string" value="yes"/>
        </configuration>
        """
            .formatted(port));
    file =
        Files.writeString(
            folder.resolve("system.xml"),
            """
            <system id="%s">
              <communication configuration="Manager.xml" host="desk"/>
              <service class="org.u2sa.cli.services.Lidar" host="bow"/>
              <service class="org.u2sa.estimation.PassThroughStateEstimator" host="bridge"/>
            </system>
            """
                .formatted(system));
  }

  private ForeignSystem host(String... arguments) {
    try {
      return ForeignSystem.start(file, port, arguments);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void run_hostsStartedInAnyOrder_areOneSystem() throws Exception {
    CompletableFuture<ForeignSystem> early =
        CompletableFuture.supplyAsync(() -> host("--host", "bow"));
    try (ForeignSystem manager = host("--host", "desk");
        ForeignSystem bridge = host("--host", "bridge", "--broker", "auto");
        ForeignSystem bow = early.get(90, TimeUnit.SECONDS)) {
      assertThat(bow.port()).isEqualTo(bridge.port());
      assertThat(manager.port()).isEqualTo(port);
      assertThat(u2sa("services", "--broker", "auto", "--system", system, "--timeout", "60"))
          .isEqualTo(ExitCode.DONE);
    }
    assertThat(out.toString())
        .contains("System " + system, "Lidar", "StateEstimator")
        .contains("Launcher-Lidar", "Launcher-StateEstimator");
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void run_hostThatTheFileDoesNotName_listsThoseItDoes() {
    assertThat(u2sa("run", file.toString(), "--host", "stern")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .contains("names no host \"stern\"; expected one of [bow, bridge, desk]");
  }

  @Test
  void run_hostAndOnly_isBadInput() {
    assertThat(u2sa("run", file.toString(), "--host", "bow", "--only", "Lidar"))
        .isEqualTo(ExitCode.BAD_INPUT);
  }

  @Test
  void run_hostAndSeparate_isBadInput() {
    assertThat(u2sa("run", file.toString(), "--host", "bow", "--separate"))
        .isEqualTo(ExitCode.BAD_INPUT);
  }
}
