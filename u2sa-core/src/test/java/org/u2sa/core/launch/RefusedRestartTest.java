package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/** A restart that the new service refuses leaves the running one alone, in every process. */
@Timeout(120)
class RefusedRestartTest {
  private static final String FENCE =
      "<fence><reference>Local ENU</reference><keepIn><corner><x>0</x><y>0</y></corner>"
          + "<corner><x>9</x><y>0</y></corner><corner><x>0</x><y>9</y></corner></keepIn></fence>";

  @TempDir private Path folder;
  private SystemFile file;
  private RunningSystem system;
  private HostedServices hosted;

  /** Holds a file as a device that only one service can open. */
  public static final class Holder extends EventDrivenService {
    private final Path device;

    public Holder(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Holder");
      Path table = context.configuration().resolve("table.txt");
      device = context.configuration().resolve("device");
      try {
        if (!Files.readString(table).equals("good")) {
          throw new BadInputException(table + ": expected \"good\"");
        }
        context.beforeDevice();
        Files.createFile(device);
        boolean isStated =
            context.configuration().enumerateFields().stream()
                .anyMatch(each -> each.getKey().equals("DELAY"));
        if (!isStated) {
          context.configuration().override("DELAY", 0.2); // as a simulated device does
        }
        getVariable(VariableDeclaration.number("DELAY", "s").ifAbsent(0.0).describedAs("Delay."));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }

    @Override
    protected void release() {
      try {
        Files.delete(device);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  @BeforeEach
  void start() throws IOException {
    write("Manager.xml", variable("BROKER", "none"));
    write("Holder.xml", "");
    write("SafetyManager.xml", variable("FENCE", "fence.xml"));
    Files.writeString(folder.resolve("fence.xml"), FENCE);
    Files.writeString(folder.resolve("table.txt"), "good");
    file =
        SystemFile.read(
            Files.writeString(
                folder.resolve("system.xml"),
                "<system id=\"test\"><communication configuration=\"Manager.xml\"/>"
                    + service(Holder.class)
                    + service(SafetyManager.class)
                    + "</system>"));
    LaunchOptions options =
        new LaunchOptions().clock(new LockstepClock()).logDirectory(folder.resolve("logs"));
    system = RunningSystem.start(file.withoutServices(), options);
    ServiceMaker maker =
        new ServiceMaker(
            "test", options, MessageTypes.discovered(), system.communicationManager().transport());
    hosted = new HostedServices(maker, false, line -> {});
    hosted.makeAll(file.services());
    hosted.services().forEach(U2SAService::start);
  }

  private static String service(Class<?> type) {
    return String.format(
        "<service class=\"%s\" configuration=\"%s.xml\"/>", type.getName(), type.getSimpleName());
  }

  private static String variable(String name, String value) {
    return String.format("<variable name=\"%s\" type=\"string\" value=\"%s\"/>", name, value);
  }

  private void write(String name, String variables) throws IOException {
    Files.writeString(folder.resolve(name), "<configuration>" + variables + "</configuration>");
  }

  @AfterEach
  void close() {
    hosted.close();
    system.close();
  }

  private void refused(String service, String reason) {
    U2SAService before = hosted.present(service).orElseThrow().service();

    assertThat(hosted.restart(service)).hasValueSatisfying(why -> assertThat(why).contains(reason));

    assertThat(hosted.present(service).orElseThrow().service())
        .isSameAs(before)
        .matches(U2SAService::isRunning);
  }

  @Test
  void restart_fenceFileBroken_safetyManagerRunsOnAndRestartsWhenItIsRight() throws IOException {
    Files.writeString(folder.resolve("fence.xml"), "<fence/>");
    refused("SafetyManager", "fence.xml");

    Files.writeString(folder.resolve("fence.xml"), FENCE);
    assertThat(hosted.restart("SafetyManager")).isEmpty();
  }

  @Test
  void restart_variableThatItsDeviceSets_isSetAgain() {
    assertThat(hosted.restart("Holder")).isEmpty();

    assertThat(hosted.present("Holder").orElseThrow().service().getVariable("DELAY"))
        .isEqualTo(0.2);
  }

  @Test
  void restart_fileOfAServiceWithADeviceBroken_serviceRunsOn() throws IOException {
    Files.writeString(folder.resolve("table.txt"), "bad");

    refused("Holder", "table.txt");
    assertThat(folder.resolve("device")).exists();
  }

  @Test
  void restart_serviceThatHoldsItsDevice_trialDoesNotOpenIt() {
    U2SAService before = hosted.services().get(0);

    assertThat(hosted.restart("Holder")).isEmpty();
    assertThat(hosted.services().get(0)).isNotSameAs(before).matches(U2SAService::isRunning);
  }

  /** The supervisor of separate processes asks this before it ends one. */
  @Test
  void refusalToRestart_ofAnotherProcess_saysWhatItsServiceWouldRefuse() throws IOException {
    SystemFile.Entry manager = file.services().get(1);
    assertThat(system.refusalToRestart(manager)).isEqualTo(Optional.empty());
    assertThat(system.refusalToRestart(file.services().get(0))).isEmpty();

    Files.writeString(folder.resolve("fence.xml"), "<fence/>");

    assertThat(system.refusalToRestart(manager).orElseThrow()).contains("fence.xml");
  }
}
