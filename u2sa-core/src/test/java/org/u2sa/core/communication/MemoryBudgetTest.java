package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Connections are named after their user and a number. */
class MemoryBudgetTest {
  private final List<String> ended = new ArrayList<>();
  private final MemoryBudget<String> budget =
      new MemoryBudget<>(100, name -> name.substring(0, 1), ended::add);

  @Test
  void set_asManyAsAllowed_nobodyIsEnded() {
    budget.set("a1", 60);
    budget.set("b1", 40);
    budget.set("a1", 60);

    assertThat(ended).isEmpty();
  }

  @Test
  void set_tooMany_endsTheLargestOfTheUserWithTheMost() {
    budget.set("b1", 45);
    budget.set("a1", 20);
    budget.set("a2", 30);
    budget.set("a1", 26);

    assertThat(ended).containsExactly("a2");
  }

  @Test
  void set_packetsBecomeComplete_makesRoom() {
    for (int i = 0; i < 10; i++) {
      budget.set("a1", 90);
      budget.set("a1", 0);
      budget.set("b1", 90);
      budget.set("b1", 0);
      budget.set("b1", 0);
    }

    assertThat(ended).isEmpty();
  }

  @Test
  void set_afterOneWasEnded_itsBytesNoLongerCount() {
    budget.set("a1", 101);
    budget.set("a1", 0);
    budget.set("b1", 100);
    assertThat(ended).containsExactly("a1");

    budget.set("c1", 1);
    assertThat(ended).containsExactly("a1", "b1");
  }
}
