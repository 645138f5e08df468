package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

class TroubleLinesTest {
  private final LocalBus bus = new LocalBus("boat");
  private final LockstepClock clock = new LockstepClock();
  private final List<String> printed = new ArrayList<>();
  private final TroubleLines lines = new TroubleLines(bus, any -> true, clock, printed::add);

  @AfterEach
  void close() {
    lines.close();
  }

  private void report(String service, String error) {
    HealthReport report =
        new HealthReport().serviceName(service).status(ServiceStatus.RUNNING).lastError(error);
    report.systemId("boat");
    report.timestamp(clock.micros());
    report.freeze();
    bus.deliver(Channels.HEALTH, report);
  }

  @Test
  void receive_boardMissing_isPrintedOnce() {
    report("IoioService", "board is lost: no /dev/ttyACM0");
    report("IoioService", "board is lost: no /dev/ttyACM0");

    assertThat(printed).containsExactly("IoioService: board is lost: no /dev/ttyACM0");
  }

  @Test
  void receive_textThatChangesEachTime_isPrintedEveryFewSeconds() throws InterruptedException {
    for (int i = 0; i < 40; i++) {
      report("Compass", "silent for " + i + " s");
      clock.advance(250_000);
    }

    assertThat(printed).containsExactly("Compass: silent for 0 s", "Compass: silent for 20 s");
  }

  @Test
  void receive_clientThatWasKilled_isNotPrinted() {
    report("u2sa-echo", "connection lost");
    report("PathPlanner", "connection lost");

    assertThat(printed).isEmpty();
  }

  @Test
  void receive_lineBreaksAndLongTexts_areOneShortLine() {
    report("Compass", "a\nb" + "x".repeat(1_000));

    assertThat(printed).singleElement().asString().doesNotContain("\n").hasSizeLessThan(400);
  }

  @Test
  void printRest_servicesThatAreNotPrintedAtOnce_haveTheirLatestLine() {
    lines.close(); // its name is free again
    List<String> some = new ArrayList<>();
    try (TroubleLines few = new TroubleLines(bus, "PathPlanner"::equals, clock, some::add)) {
      report("PathPlanner", "no plan");
      report("StateEstimator", "state lacks z");
      report("StateEstimator", "state lacks x, y");
      assertThat(some).containsExactly("PathPlanner: no plan");

      few.printRest();
    }
    assertThat(some).containsExactly("PathPlanner: no plan", "StateEstimator: state lacks x, y");
  }
}
