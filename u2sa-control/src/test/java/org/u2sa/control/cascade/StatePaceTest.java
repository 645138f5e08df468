package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;

/** Warns of states that come too seldom or too late for the rate loops. */
class StatePaceTest {
  private final CascadeVariables tuning =
      new CascadeVariables(
          XmlConfiguration.inMemory("Control", Map.of("ROLL GAIN", 8.0, "PITCH GAIN", 10.0)));
  private final StatePace pace = new StatePace();
  private final List<String> said = new ArrayList<>();

  private void pass(double seconds, double stepS, double ageS) {
    for (double s = 0.0; s < seconds; s += stepS) {
      pace.step(tuning, stepS, ageS).ifPresent(said::add);
    }
  }

  @Test
  void step_quickStates_saysNothing() {
    pass(60.0, 0.02, 0.02);
    assertThat(said).isEmpty();
  }

  @Test
  void step_seldomThenOftenAgain_warnsOnceAndRetracts() {
    pass(60.0, 0.1, 0.0);
    assertThat(said).hasSize(1);
    assertThat(said.get(0)).contains("PITCH GAIN 10.0 1/s", "above 50 ms");
    pass(60.0, 0.02, 0.0);
    assertThat(said).hasSize(2).endsWith("");
  }

  @Test
  void step_oftenButOld_warns() {
    pass(60.0, 0.02, 0.05);
    assertThat(said).hasSize(1);
  }
}
