package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.testkit.FreePort;

/** A system that cannot be started leaves nothing behind. */
@Timeout(120)
class FailedStartTest {
  @TempDir private Path directory;

  /** Fails after it has connected, as a service whose device is missing. */
  public static final class Stillborn extends EventDrivenService {
    public Stillborn(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Stillborn");
      throw new IllegalStateException("no device");
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  @Test
  void start_constructorFailsWithAnExternalBroker_leavesNoConnectionBehind() throws IOException {
    int port = FreePort.find();
    SystemFile file =
        SystemFile.read(
            Files.writeString(
                directory.resolve("system.xml"),
                "<system id=\"test\"><service class=\""
                    + Stillborn.class.getName()
                    + "\"/></system>"));
    LaunchOptions options =
        new LaunchOptions()
            .logDirectory(directory.resolve("logs"))
            .override("CommunicationManager", "BROKER", "external")
            .override("CommunicationManager", "COMMUNICATION MANAGER PORT", port);
    XmlConfiguration ofBroker =
        XmlConfiguration.inMemory("test", Map.of("COMMUNICATION MANAGER PORT", port));
    try (CommunicationManager broker =
        CommunicationManager.start("test", ofBroker, StandardTypes.registry(), line -> {})) {
      assertThat(broker.address()).isPresent();

      assertThatThrownBy(() -> RunningSystem.start(file, options)).hasMessage("no device");

      await()
          .atMost(Duration.ofSeconds(60))
          .untilAsserted(() -> assertThat(clientThreads()).isEmpty());
    }
  }

  /** A service of the default name that its class gives. */
  public static final class Twin extends EventDrivenService {
    public Twin(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Twin");
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  @Test
  void start_nameTakenByAnotherEntry_isRefusedNamingBothLines() throws IOException {
    String entry = "  <service class=\"" + Twin.class.getName() + "\"/>\n";
    Path written =
        Files.writeString(
            directory.resolve("system.xml"),
            "<system id=\"test\">\n" + entry + entry + "</system>");
    LaunchOptions options =
        new LaunchOptions()
            .logDirectory(directory.resolve("logs"))
            .override("CommunicationManager", "BROKER", "none");

    assertThatThrownBy(() -> RunningSystem.start(SystemFile.read(written), options))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            written
                + ", line 3, <service>: service name \"Twin\" is taken by the service in line 2;"
                + " expected another SERVICE NAME in its configuration");
  }

  private static List<String> clientThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("MQTT ") && name.contains("test/Stillborn/"))
        .collect(Collectors.toList());
  }
}
