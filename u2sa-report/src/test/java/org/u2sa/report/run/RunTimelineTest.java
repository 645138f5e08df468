package org.u2sa.report.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

class RunTimelineTest {
  private static final int MAX_CHARACTERS = 2_500_000; // of the page's timeline

  private final RunTimeline timeline = new RunTimeline();

  private static String text(int n) {
    return n + "x".repeat(60_000);
  }

  @Test
  void take_longCausesByTheThousand_areCutAndCounted() {
    IntStream.range(0, 3_000)
        .forEach(
            n ->
                timeline.take(
                    n, new FailsafeState().action(FailsafeAction.HOLD).causes(List.of(text(n)))));

    String json = timeline.json().line();
    assertThat(json)
        .contains("HOLD: 1999x", " characters)", "\"leftOut\":1000")
        .hasSizeLessThan(MAX_CHARACTERS);
    assertThat(timeline.count("failsafe", true)).isEqualTo(2_000);
  }

  @Test
  void take_inventedServicesByTheThousand_areBounded() {
    IntStream.range(0, 6_000)
        .forEach(
            n -> {
              timeline.take(
                  n, new HealthReport().serviceName("s" + n).lastError(n + "x".repeat(2_000)));
              timeline.take(
                  n, new ServiceCondition().serviceName("s" + n).condition(Condition.DEAD));
            });

    assertThat(timeline.json().line())
        .hasSizeLessThan(2 * MAX_CHARACTERS)
        .doesNotContain("\"leftOut\":0");
  }

  @Test
  void take_sameCauseAgain_isOneEvent() {
    FailsafeState state = new FailsafeState().action(FailsafeAction.HOLD).causes(List.of("link"));
    timeline.take(1.0, state);
    timeline.take(2.0, state);

    assertThat(timeline.count("failsafe", true)).isEqualTo(1);
    assertThat(timeline.json().line()).contains("HOLD: link", "\"leftOut\":0");
  }

  @Test
  void servicesNotAlive_conditions_countsServicesNotEvents() {
    for (int i = 0; i < 3; i++) {
      timeline.take(2 * i, new ServiceCondition().serviceName("s").condition(Condition.SILENT));
      timeline.take(2 * i + 1, new ServiceCondition().serviceName("s").condition(Condition.ALIVE));
    }
    timeline.take(9.0, new ServiceCondition().serviceName("t").condition(Condition.STOPPED));

    assertThat(timeline.servicesNotAlive()).isEqualTo(1);
  }
}
