package org.u2sa.drivers.compass;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.link.MemoryLink;

/** A compass that measures 20 times a second, and answers 100 requests a second. */
class PolledCompassTest {
  private static final long STEP_MICROS = 10_000;
  private static final long PERIOD_MICROS = 50_000;

  private final MemoryLink link = new MemoryLink();
  private final LinkedCompass compass = LinkedCompass.sparton(link);
  private final List<Heading> headings = new ArrayList<>();
  private long micros;
  private int unitsPerMeasurement;

  PolledCompassTest() {
    link.with(asked -> answer());
  }

  private void answer() {
    int units = 1000 + (int) (micros / PERIOD_MICROS) * unitsPerMeasurement;
    link.fromDevice((byte) 0xA4, (byte) 9, (byte) (units >> 8), (byte) units, (byte) 0xA0);
  }

  private void read(int steps) {
    for (int i = 0; i < steps; i++) {
      Optional<Heading> heading = compass.read(micros);
      heading.filter(each -> !headings.contains(each)).ifPresent(headings::add);
      micros += STEP_MICROS;
    }
  }

  @Test
  void read_turnsAndIsPolledFasterThanItMeasures_givesEachHeadingOnce() {
    unitsPerMeasurement = 40;
    read(101);

    assertThat(headings).extracting(Heading::headingRad).doesNotHaveDuplicates().hasSize(20);
  }

  @Test
  void read_headingStaysTheSame_isMeasuredAgainWithEachPeriod() {
    read(101);

    assertThat(headings).hasSize(20);
    assertThat(headings)
        .extracting(Heading::measuredAtMicros)
        .allMatch(at -> (at - STEP_MICROS) % PERIOD_MICROS == 0);
  }

  @Test
  void read_answerHasWaitedDuringAPause_isNotUsed() {
    unitsPerMeasurement = 40;
    read(24); // the last request was sent before the measurement at 0.25 s
    micros += 110_000;
    long resumedMicros = micros;
    read(5);

    assertThat(headings).noneMatch(each -> each.measuredAtMicros() == resumedMicros);
    assertThat(headings).last().extracting(Heading::measuredAtMicros).isNotEqualTo(230_000L);
  }

  @Test
  void read_seldom_givesEverySecondAnswer() {
    unitsPerMeasurement = 40;
    for (int i = 0; i < 20; i++) {
      read(1);
      micros += 90_000;
    }

    assertThat(headings).hasSizeBetween(8, 10);
  }
}
