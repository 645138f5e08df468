package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.testkit.FreePort;

/** Two processes of one system that are both to run a service of the same name. */
@Timeout(180)
class DuplicateCheckTest {
  private static final long HOUR = 3_600_000_000L; // µs
  private static final int ATTEMPTS = 20; // a busy machine may answer later than is waited for

  @TempDir private Path folder;
  private final int port = FreePort.find();

  private SystemFile system() throws IOException {
    Files.writeString(
        folder.resolve("Manager.xml"),
        "<configuration><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
            + port
            + "\"/></configuration>");
    return SystemFile.read(
        Files.writeString(
            folder.resolve("system.xml"),
            "<system id=\"boat\"><communication configuration=\"Manager.xml\"/><service class=\""
                + RunningSystemTest.Quiet.class.getName()
                + "\"/></system>"));
  }

  private LaunchOptions options() {
    return new LaunchOptions().logDirectory(folder.resolve("logs"));
  }

  private LaunchOptions elsewhere() {
    return options().oneOfSeveral(false).override("CommunicationManager", "BROKER", "external");
  }

  private Optional<String> refusal() throws IOException {
    try (RunningSystem second = RunningSystem.start(system(), elsewhere())) {
      assertThat(second.isRunning()).isTrue();
      return Optional.empty();
    } catch (CommunicationException e) {
      return Optional.of(e.getMessage());
    }
  }

  @Test
  void start_serviceThatRunsInAnotherProcess_isRefusedAndTheFirstGoesOn() throws IOException {
    try (RunningSystem first = RunningSystem.start(system(), options())) {
      Optional<String> refusal = Optional.empty();
      for (int i = 0; i < ATTEMPTS && refusal.isEmpty(); i++) {
        refusal = refusal();
      }

      assertThat(refusal.orElseThrow())
          .startsWith("service name \"Quiet\" is taken in system \"boat\" by a service on host \"");
      assertThat(first.isRunning()).isTrue();
    }
  }

  @Test
  void start_besideTheManager_believesNoAnswer() throws IOException {
    LaunchOptions beside = elsewhere().besideManager(true).clock(new SystemClock().ahead(HOUR));
    try (RunningSystem first = RunningSystem.start(system(), options());
        RunningSystem second = RunningSystem.start(system(), beside)) {
      assertThat(first.isRunning()).isTrue();
      Clock kept = second.contextFor(XmlConfiguration.inMemory("test", Map.of())).clock();

      assertThat(second.isRunning()).as("though its name is in use").isTrue();
      assertThat(kept.micros() - new SystemClock().micros()).isGreaterThan(HOUR / 2);
    }
  }

  @Test
  void start_otherProcessRunsOtherServices_isWelcome() throws IOException {
    try (RunningSystem first = RunningSystem.start(system().withoutServices(), options())) {
      assertThat(first.isRunning()).isFalse();
      assertThat(refusal()).isEmpty();
    }
  }
}
