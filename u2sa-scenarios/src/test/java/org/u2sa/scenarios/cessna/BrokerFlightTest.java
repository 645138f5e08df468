package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.FreePort;

/** A flight in real time whose services talk through the broker only, as in the thesis. */
@Tag("long")
@Timeout(600)
class BrokerFlightTest {
  @TempDir private Path directory;

  @Test
  void demo_throughBrokerInRealTime_takesOffAndPassesItsWaypoint() {
    Path out = directory.resolve("out");

    CommandLineRun run =
        CommandLineRun.of(
            "demo",
            "cessna",
            "--through-broker",
            "--realtime",
            "--wind",
            "calm",
            "--port",
            String.valueOf(FreePort.find()),
            "--mission",
            ShortMission.in(directory).toString(),
            "--out",
            out.toString());

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(Summary.in(out).number("waypointsCaptured")).isOne();
  }
}
