package org.u2sa.cli.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;
import org.u2sa.gcs.remote.LocalSystems;
import org.u2sa.interfaces.mqtt.AccountFolders;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.TcpRelay;
import picocli.CommandLine;

/** The operator's commands on a system in a process of its own. */
@Timeout(180)
class SafetyCommandsTest {
  @TempDir private static Path directory;
  private static ForeignSystem foreign;
  private final StringWriter out = new StringWriter();

  @BeforeAll
  static void start() {
    foreign =
        ForeignSystem.start(
            directory, "boat", "org.u2sa.core.safety.SafetyManager", ObedientMotor.class.getName());
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private int run(Object command, String... arguments) {
    return run(foreign.broker(), "boat", command, arguments);
  }

  private int run(String broker, String system, Object command, String... arguments) {
    CommandLine line = new CommandLine(command).setOut(new PrintWriter(out));
    String[] all = new String[arguments.length + 4];
    System.arraycopy(arguments, 0, all, 4, arguments.length);
    all[0] = "--broker";
    all[1] = broker;
    all[2] = "--system";
    all[3] = system;
    return line.execute(all);
  }

  @Test
  void arm_vehicleThatIsNotReady_saysWhyAndFails() {
    assertThat(run(new ArmingCommand.Arm())).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .startsWith("boat: not armed")
        .contains("position: no state yet", "mission: no goals");
    assertThat(run(new ArmingCommand.Disarm())).isEqualTo(ExitCode.DONE);
  }

  @Test
  void estop_thenClear_holdsInBetween() {
    assertThat(run(new EmergencyStopCommand(), "--reason", "smoke")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .startsWith("boat: Emergency stop, confirmed by Motor, SafetyManager");
    run(new ArmingCommand.Arm());
    assertThat(out.toString()).contains("emergency stop by ").contains(": smoke");

    assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("Emergency stop cleared, confirmed by Motor, SafetyManager");
    out.getBuffer().setLength(0);
    run(new ArmingCommand.Arm());

    assertThat(out.toString()).doesNotContain("emergency stop");
  }

  @Test
  void estop_noSystemChosen_stopsAllThatTheBrokerServes() throws Exception {
    try (ReportingBuoy buoy = ReportingBuoy.join(foreign.port(), "buoy")) {
      CommandLine line =
          new CommandLine(new EmergencyStopCommand()).setOut(new PrintWriter(out, true));

      assertThat(line.execute("--broker", foreign.broker(), "--timeout", "10"))
          .isEqualTo(ExitCode.DONE);

      assertThat(out.toString())
          .contains("boat: Emergency stop, confirmed by Motor, SafetyManager")
          .contains(buoy.systemId() + ": Emergency stop, confirmed by Buoy");
      assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
    }
  }

  @Test
  void estop_brokerTooBusyAtFirst_triesAgain() throws IOException {
    StringWriter err;
    try (TcpRelay relay = new TcpRelay(foreign.port())) {
      relay.cut(); // ends each connection without an answer
      err =
          new StringWriter() {
            @Override
            public void write(String text, int from, int length) {
              super.write(text, from, length);
              relay.restore();
            }
          };
      CommandLine line = new CommandLine(new EmergencyStopCommand());
      line.setOut(new PrintWriter(out, true)).setErr(new PrintWriter(err, true));
      String broker = "127.0.0.1:" + relay.port();
      Path tokens = AccountFolders.ofProcess().all().get(0);
      Path token = tokens.resolve(LocalToken.fileName("127.0.0.1", relay.port()));
      Files.copy(tokens.resolve(LocalToken.fileName("127.0.0.1", foreign.port())), token);

      assertThat(line.execute("--broker", broker, "--system", "boat", "--timeout", "2"))
          .isEqualTo(ExitCode.DONE);
      Files.delete(token);
    }
    assertThat(err.toString()).contains("does not answer yet: trying again");
    assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
  }

  @Test
  void estop_twiceThenOneClear_liftsBoth() {
    run(new EmergencyStopCommand(), "--reason", "smoke");
    run(new EmergencyStopCommand(), "--reason", "fire");

    assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
  }

  @Test
  void parts_stopsWithLongIds_fitIntoMessagesAndNoneIsLost() {
    List<String> stops =
        IntStream.range(0, 64).mapToObj(i -> i + "\u00e4".repeat(900 - i)).toList();
    List<List<String>> parts = EmergencyStopCommand.parts(stops);
    assertThat(parts.stream().flatMap(List::stream)).containsExactlyElementsOf(stops);
    assertThat(parts)
        .allMatch(part -> String.join("", part).getBytes(StandardCharsets.UTF_8).length <= 12_000);
    assertThat(EmergencyStopCommand.parts(List.of())).isEmpty();
  }

  @Test
  void estop_oneOfSeveralBrokersDoesNotAnswer_stopsTheOthersAndFails() {
    LocalSystems.Announcement hung =
        LocalSystems.ofAccount()
            .announce(
                "boat",
                Optional.of(new InetSocketAddress("127.0.0.1", FreePort.find())),
                line -> {});
    CommandLine line =
        new CommandLine(new EmergencyStopCommand()).setOut(new PrintWriter(out, true));

    assertThat(line.execute("--system", "boat", "--timeout", "10")).isEqualTo(ExitCode.FAILED);

    assertThat(out.toString())
        .contains("boat: Emergency stop, confirmed by Motor, SafetyManager")
        .contains("NOT STOPPED: no Communication Manager at");
    hung.close();
    assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
  }

  @Test
  void estop_partOfTheRegistryCannotBeRead_saysSoAndStopsWhatItFinds() throws IOException {
    Path folder = AccountFolders.ofProcess().all().get(0);
    Path entry = folder.resolve(ProcessHandle.current().pid() + "-1"); // a folder, so no entry
    Path inside = Files.createDirectories(entry.resolve("inside")); // so that it stays
    StringWriter err = new StringWriter();
    try {
      CommandLine line = new CommandLine(new EmergencyStopCommand());
      line.setOut(new PrintWriter(out, true)).setErr(new PrintWriter(err, true));
      assertThat(line.execute("--system", "boat", "--timeout", "10")).isEqualTo(ExitCode.DONE);
    } finally {
      Files.delete(inside);
      Files.delete(entry);
    }

    assertThat(out.toString()).contains("boat: Emergency stop, confirmed by Motor, SafetyManager");
    assertThat(err.toString()).contains(entry.toString());
    assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void orders_accountHasNoToken_saySoAndWhereTheyLooked() throws IOException {
    StringWriter err = new StringWriter();
    String name = LocalToken.fileName("127.0.0.1", foreign.port());
    List<Path> tokens =
        AccountFolders.ofProcess().all().stream().map(folder -> folder.resolve(name)).toList();
    for (Path token : tokens) { // open to others, so not used, and there, so not written again
      Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("rw-r--r--"));
    }
    try {
      CommandLine line = new CommandLine(new EmergencyStopCommand());
      line.setOut(new PrintWriter(out, true)).setErr(new PrintWriter(err, true));
      assertThat(line.execute("--broker", foreign.broker(), "--timeout", "1"))
          .isEqualTo(ExitCode.FAILED);
      assertThat(out.toString()).contains("NOT CONFIRMED");
      assertThat(err.toString()).contains("no token").contains(tokens.get(0).toString());
    } finally {
      for (Path token : tokens) {
        Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("rw-------"));
      }
    }
  }

  @Test
  void operator_forAWhile_showsArmingAndFailsafe() {
    assertThat(run(new OperatorCommand(), "--for", "1.5")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("arming: not armed: [", "failsafe: ");
  }
}
