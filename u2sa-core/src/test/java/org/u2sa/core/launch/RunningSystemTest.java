package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

@Timeout(120)
class RunningSystemTest {
  @TempDir private Path directory;

  /** A service that keeps quiet. */
  public static class Quiet extends EventDrivenService {
    private static final VariableDeclaration<Double> GAIN =
        VariableDeclaration.number("GAIN", "").range(Range.of(0.0, 1.0)).ifAbsent(0.5);

    public Quiet(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Quiet");
      getVariable(GAIN);
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  /** Another one, with another name. */
  public static final class AlsoQuiet extends Quiet {
    public AlsoQuiet(ServiceContext context) {
      super(context);
    }
  }

  /** One that needs more than a context. */
  public static final class Equipped extends Quiet {
    private final String equipment;

    Equipped(ServiceContext context, String equipment) {
      super(context);
      this.equipment = equipment;
    }
  }

  /** Not a service. */
  public static final class NoService {}

  private Path file(String name, String text) throws IOException {
    return Files.writeString(directory.resolve(name), text);
  }

  private SystemFile system(String... services) throws IOException {
    file(
        "Manager.xml",
        "<configuration><variable name=\"BROKER\" type=\"string\" value=\"none\"/></configuration>");
    return SystemFile.read(
        file(
            "system.xml",
            "<system id=\"test\">\n<communication configuration=\"Manager.xml\"/>\n"
                + String.join("\n", services)
                + "\n</system>\n"));
  }

  private static String service(Class<?> type, String configuration) {
    return "<service class=\"" + type.getName() + "\" configuration=\"" + configuration + "\"/>";
  }

  private static String configuration(String... variables) {
    return "<configuration>\n" + String.join("\n", variables) + "\n</configuration>\n";
  }

  private LaunchOptions options() {
    return new LaunchOptions().clock(new LockstepClock()).logDirectory(directory.resolve("logs"));
  }

  @Test
  void start_thenStopCommand_endsAllServicesAndLeavesALogEach() throws Exception {
    file("Quiet.xml", configuration());
    file(
        "Also.xml",
        configuration("<variable name=\"SERVICE NAME\" type=\"string\" value=\"Also\"/>"));
    LockstepClock clock = new LockstepClock();
    SystemFile file =
        system(service(Quiet.class, "Quiet.xml"), service(AlsoQuiet.class, "Also.xml"));
    try (RunningSystem system = RunningSystem.start(file, options().clock(clock))) {
      clock.advance(1_000_000);
      assertThat(system.isRunning()).isTrue();
      assertThat(system.services()).extracting(Thread::getName).containsExactly("Quiet", "Also");

      system.services().get(0).publish(Channels.STOP, new StopCommand().stopAll(true));
      clock.advance(0);
      system.awaitEnd();

      assertThat(system.isRunning()).isFalse();
      assertThat(system.failed()).isEmpty();
    }
    assertThat(directory.resolve("logs/Quiet.log")).exists();
    assertThat(directory.resolve("logs/Also.log")).exists();
  }

  @Test
  void start_classThatOnlyTheProgramCanMake_isMadeByIt() throws IOException {
    file("Quiet.xml", configuration());
    LaunchOptions options =
        options().making(Equipped.class, context -> new Equipped(context, "a phone"));
    SystemFile file = system(service(Equipped.class, "Quiet.xml"));

    try (RunningSystem system = RunningSystem.start(file, options)) {
      assertThat(system.services().get(0))
          .isInstanceOfSatisfying(
              Equipped.class, made -> assertThat(made.equipment).isEqualTo("a phone"));
    }
    assertThatThrownBy(() -> RunningSystem.start(file, options()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("public constructor (ServiceContext)");
  }

  @Test
  void start_override_holdsForTheRunAndLeavesTheFileAlone() throws IOException {
    Path path =
        file(
            "Quiet.xml", configuration("<variable name=\"GAIN\" type=\"double\" value=\"0.25\"/>"));
    String before = Files.readString(path);
    LaunchOptions options = options().override("Quiet", "GAIN", 0.75);

    try (RunningSystem system =
        RunningSystem.start(system(service(Quiet.class, "Quiet.xml")), options)) {
      assertThat(system.services().get(0).getVariable("GAIN")).isEqualTo(0.75);
    }
    assertThat(Files.readString(path)).isEqualTo(before);
  }

  @Test
  void start_secondServicesConfigurationWrong_startsNothingAndNamesFileLineVariable()
      throws IOException {
    file("Quiet.xml", configuration());
    file(
        "Also.xml",
        configuration(
            "<variable name=\"GAIN\" type=\"double\" value=\"7\"/>",
            "<variable name=\"SERVICE NAME\" type=\"string\" value=\"Also\"/>"));
    SystemFile file =
        system(service(Quiet.class, "Quiet.xml"), service(AlsoQuiet.class, "Also.xml"));
    List<String> before = threads();

    assertThatThrownBy(() -> RunningSystem.start(file, options()))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("Also.xml, line 2")
        .hasMessageContaining("GAIN")
        .hasMessageContaining("7");
    assertThat(threads()).isEqualTo(before);
  }

  private static List<String> threads() {
    List<String> names = new ArrayList<>();
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (thread.getName().startsWith("Quiet") || thread.getName().startsWith("Also")) {
        names.add(thread.getName());
      }
    }
    return names;
  }

  @Test
  void start_misspeltVariable_isRefused() throws IOException {
    file("Quiet.xml", configuration("<variable name=\"GIAN\" type=\"double\" value=\"0.1\"/>"));
    SystemFile file = system(service(Quiet.class, "Quiet.xml"));

    assertThatThrownBy(() -> RunningSystem.start(file, options()))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("Quiet.xml, line 2")
        .hasMessageContaining("GIAN");
  }

  @Test
  void start_unknownClass_namesFileLineAndClass() throws IOException {
    SystemFile file = system("<service class=\"org.example.Nothing\"/>");

    assertThatThrownBy(() -> RunningSystem.start(file, options()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("system.xml, line 3")
        .hasMessageContaining("org.example.Nothing")
        .hasMessageContaining("not on the class path");
  }

  @Test
  void start_classIsNoService_isRefused() throws IOException {
    SystemFile file = system("<service class=\"" + NoService.class.getName() + "\"/>");

    assertThatThrownBy(() -> RunningSystem.start(file, options()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("is not a service");
  }

  @Test
  void read_missingConfigurationFile_namesIt() {
    assertThatThrownBy(() -> system(service(Quiet.class, "Absent.xml")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("system.xml, line 3")
        .hasMessageContaining("Absent.xml");
  }

  @Test
  void read_badSystemId_isRefused() throws IOException {
    Path path = file("bad.xml", "<system id=\"a/b\"><service class=\"x\"/></system>");

    assertThatThrownBy(() -> SystemFile.read(path))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("bad.xml, line 1")
        .hasMessageContaining("a/b");
  }

  @Test
  void read_noService_isRefused() throws IOException {
    Path path = file("bad.xml", "<system id=\"a\"/>");

    assertThatThrownBy(() -> SystemFile.read(path))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("lists no service");
  }

  @Test
  void start_logsWhereAFileIs_isRefused() throws IOException {
    Path logs = file("logs", "");
    file("Quiet.xml", configuration());
    SystemFile system = system(service(Quiet.class, "Quiet.xml"));

    assertThatThrownBy(() -> RunningSystem.start(system, new LaunchOptions().logDirectory(logs)))
        .isInstanceOf(BadInputException.class)
        .hasMessage(logs + ": is not a folder, expected one for log files");
  }
}
