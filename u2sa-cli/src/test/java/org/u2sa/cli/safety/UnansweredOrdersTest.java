package org.u2sa.cli.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;
import picocli.CommandLine;

/** Orders that wait their whole time limit, because nobody or not everybody obeys. */
@Timeout(180)
class UnansweredOrdersTest {
  @TempDir private static Path directory;
  private static ForeignSystem boat;
  private final StringWriter out = new StringWriter();

  @BeforeAll
  static void start() {
    boat =
        ForeignSystem.start(
            directory, "boat", ObedientMotor.class.getName(), DeafWinch.class.getName());
  }

  @AfterAll
  static void end() {
    boat.close();
  }

  private int run(String system, Object command, String... arguments) {
    Stream<String> all =
        Stream.of("--broker", boat.broker(), "--system", system, "--timeout", "10");
    return new CommandLine(command)
        .setOut(new PrintWriter(out))
        .execute(Stream.concat(all, List.of(arguments).stream()).toArray(String[]::new));
  }

  @Test
  void orders_toASystemThatIsNotThere_failAndNameTheNearest() {
    assertThat(run("baot", new EmergencyStopCommand())).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .contains("baot: Emergency stop was sent, but NOT CONFIRMED")
        .contains("the order may still be carried out, whenever it is delivered")
        .contains("no service of system \"baot\" is heard")
        .contains("did you mean \"boat\"?");
    out.getBuffer().setLength(0);
    assertThat(run("baot", new ArmingCommand.Arm())).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .contains("no Safety Manager answered")
        .contains("the order may still be carried out if it is delivered within ORDER EXPIRY")
        .contains("did you mean \"boat\"?");
  }

  @Test
  void estop_partOfTheVehicleDoesNotObey_failsAndSaysWhich() {
    assertThat(run("boat", new EmergencyStopCommand())).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .contains("boat: Emergency stop was sent, but NOT CONFIRMED by all; confirmed by Motor")
        .contains("Winch is not stopped");
  }

  @Test
  void operator_ofASystemThatIsNotThere_failsAndNamesTheNearest() {
    assertThat(run("baot", new OperatorCommand(), "--for", "1")).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString())
        .contains("baot: no Safety Manager answers")
        .contains("did you mean \"boat\"?");
  }
}
