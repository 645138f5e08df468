package org.u2sa.cli.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;
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
  void estop_twiceThenOneClear_liftsBoth() {
    run(new EmergencyStopCommand(), "--reason", "smoke");
    run(new EmergencyStopCommand(), "--reason", "fire");

    assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
  }

  @Test
  void orders_toASystemThatIsNotThere_failAndNameTheNearest() {
    assertThat(run(foreign.broker(), "baot", new EmergencyStopCommand(), "--timeout", "10"))
        .isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .contains("baot: Emergency stop was sent, but NOT CONFIRMED")
        .contains("no service of system \"baot\" is heard")
        .contains("did you mean \"boat\"?");
    out.getBuffer().setLength(0);
    assertThat(run(foreign.broker(), "baot", new ArmingCommand.Arm(), "--timeout", "10"))
        .isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .contains("no Safety Manager answered")
        .contains("did you mean \"boat\"?");
  }

  @Test
  void estop_partOfTheVehicleDoesNotObey_failsAndSaysWhich(@TempDir Path other) {
    try (ForeignSystem ship =
        ForeignSystem.start(
            other, "ship", ObedientMotor.class.getName(), DeafWinch.class.getName())) {
      assertThat(run(ship.broker(), "ship", new EmergencyStopCommand(), "--timeout", "10"))
          .isEqualTo(ExitCode.FAILED);
      assertThat(out.toString())
          .contains("ship: Emergency stop was sent, but NOT CONFIRMED by all; confirmed by Motor")
          .contains("Winch is not stopped");
    }
  }

  @Test
  void operator_forAWhile_showsArmingAndFailsafe() {
    assertThat(run(new OperatorCommand(), "--for", "1.5")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("arming: not armed: [", "failsafe: ");
  }

  @Test
  void operator_ofASystemThatIsNotThere_failsAndNamesTheNearest() {
    assertThat(
            run(foreign.broker(), "baot", new OperatorCommand(), "--for", "1", "--timeout", "10"))
        .isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .contains("baot: no Safety Manager answers")
        .contains("did you mean \"boat\"?");
  }
}
