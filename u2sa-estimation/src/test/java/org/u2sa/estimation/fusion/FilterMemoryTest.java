package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.Measurement;

class FilterMemoryTest {
  @Test
  void read_whatAnotherFilterWrote_goesOnFromTheSameNumbers() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
    Measurement m = new Measurement();
    for (int i = 1; i <= 300; i++) {
      m.begin("gps", i * 20_000L).localPlace(0.02 * i + i % 3, i % 5, 1.0);
      filter.add(m.heading(0.001 * i, 0.02));
    }
    Map<String, String> texts = new HashMap<>();
    FilterMemory.write(filter, texts::put);

    ErrorStateFilter next = new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
    assertThat(FilterMemory.read(next, name -> Optional.ofNullable(texts.get(name)))).isTrue();
    assertThat(next.state().x).isEqualTo(filter.state().x);
    assertThat(next.state().p.data).isEqualTo(filter.state().p.data);
    assertThat(next.state().variance(FilterState.POSITION)).isPositive();
  }
}
