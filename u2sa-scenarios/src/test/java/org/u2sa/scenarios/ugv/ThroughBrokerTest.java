package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.FreePort;

/** A short drive whose services talk through the broker only. */
@Timeout(180)
class ThroughBrokerTest {
  private static final String TWO_WAYPOINTS =
      """
      <mission>
        <home><x>-81.0478</x><y>29.1885</y><psi>0.0</psi></home>
        <waypoint><x>-81.0478</x><y>29.188530</y><horizontalThreshold>0.8</horizontalThreshold></waypoint>
        <waypoint><x>-81.04777</x><y>29.188550</y><horizontalThreshold>0.8</horizontalThreshold></waypoint>
      </mission>
      """;

  @TempDir private Path directory;

  @Test
  void demo_throughBrokerInRealTime_passesBothWaypoints() throws IOException {
    Path mission = Files.writeString(directory.resolve("two.xml"), TWO_WAYPOINTS);

    CommandLineRun run =
        CommandLineRun.demo(
            "ugv",
            directory.resolve("out"),
            FreePort.find(),
            "--through-broker",
            "--realtime",
            "--mission",
            mission.toString());

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(run.summary().get("goalsCompleted").asInt()).isEqualTo(2);
  }

  @Test
  void demo_throughBrokerInLockstepOrWithoutOne_isRefused() {
    CommandLineRun lockstep =
        CommandLineRun.demo("ugv", directory, FreePort.find(), "--through-broker");
    assertThat(lockstep.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(lockstep.err()).contains("take real time; expected --realtime");

    CommandLineRun without =
        CommandLineRun.demo("ugv", directory, "--through-broker", "--realtime");
    assertThat(without.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(without.err()).contains("is none; expected embedded or external");
  }
}
