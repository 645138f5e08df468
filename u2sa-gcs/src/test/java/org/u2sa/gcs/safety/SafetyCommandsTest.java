package org.u2sa.gcs.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.gcs.ExitCode;
import org.u2sa.gcs.remote.ForeignSystem;
import picocli.CommandLine;

/** The operator's commands on a system in a process of its own. */
@Timeout(60)
class SafetyCommandsTest {
  @TempDir private static Path directory;
  private static ForeignSystem foreign;
  private final StringWriter out = new StringWriter();

  @BeforeAll
  static void start() {
    foreign = ForeignSystem.start(directory, "boat", "org.u2sa.core.safety.SafetyManager");
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private int run(Object command, String... arguments) {
    CommandLine line = new CommandLine(command).setOut(new PrintWriter(out));
    String[] all = new String[arguments.length + 4];
    System.arraycopy(arguments, 0, all, 4, arguments.length);
    all[0] = "--broker";
    all[1] = foreign.broker();
    all[2] = "--system";
    all[3] = "boat";
    return line.execute(all);
  }

  @Test
  void arm_vehicleThatIsNotReady_saysWhyAndFails() {
    assertThat(run(new ArmVehicleCommand())).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .startsWith("boat: not armed")
        .contains("position: no state yet", "mission: no goals", "actuators: none is there");
    assertThat(run(new DisarmVehicleCommand())).isEqualTo(ExitCode.DONE);
  }

  @Test
  void estop_thenClear_holdsInBetween() {
    assertThat(run(new EmergencyStopCommand(), "--reason", "smoke")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).startsWith("boat: Emergency stop (the broker had it after ");
    run(new ArmVehicleCommand());
    assertThat(out.toString()).contains("emergency stop by ").contains(": smoke");

    assertThat(run(new EmergencyStopCommand(), "--clear")).isEqualTo(ExitCode.DONE);
    out.getBuffer().setLength(0);
    run(new ArmVehicleCommand());

    assertThat(out.toString()).doesNotContain("emergency stop");
  }

  @Test
  void operator_forAWhile_showsArmingAndFailsafe() {
    assertThat(run(new OperatorCommand(), "--for", "1.5")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("arming: not armed: [", "failsafe: ");
  }
}
