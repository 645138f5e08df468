package org.u2sa.cli.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.LongFunction;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;

class MeasuredSourcesTest {
  private static final long SECOND = 1_000_000;

  static Stream<Arguments> meters() {
    return Stream.of(
        Arguments.of(Meter.Rate.COLUMNS, (LongFunction<Meter>) began -> new Meter.Rate()),
        Arguments.of(Meter.Delay.COLUMNS, (LongFunction<Meter>) began -> new Meter.Delay()),
        Arguments.of(Meter.Bandwidth.COLUMNS, (LongFunction<Meter>) Meter.Bandwidth::new));
  }

  @ParameterizedTest
  @MethodSource("meters")
  void table_sourceThatDied_saysHowLongAgoItsLastMessageCame(
      List<String> columns, LongFunction<Meter> meterFrom) {
    MeasuredSources sources = new MeasuredSources(columns, meterFrom);
    sources.take(Channels.SENSED_STATE, state("Compass"), SECOND, 0);
    sources.take(Channels.SENSED_STATE, state("GPS"), 2 * SECOND, 0);
    sources.take(Channels.SENSED_STATE, state("GPS"), 61 * SECOND, 0);
    List<String> lines = sources.table(62 * SECOND).lines();
    assertThat(lines).hasSize(3);
    assertThat(lines.get(0)).endsWith("LAST");
    assertThat(lines.get(1)).contains("Compass").endsWith("61.0 s ago");
    assertThat(lines.get(2)).contains("GPS").endsWith("1.0 s ago");
    assertThat(sources.json(62 * SECOND)).contains("\"lastAgoS\":61.0", "\"lastAgoS\":1.0");
  }

  private static StateInformation state(String sensor) {
    StateInformation state = new StateInformation().sensorName(sensor);
    state.timestamp(1);
    return state;
  }
}
