package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Connections are named after their user and a number. */
class UnfinishedPacketsTest {
  private final List<String> ended = new ArrayList<>();
  private final UnfinishedPackets<String> unfinished =
      new UnfinishedPackets<>(100, name -> name.substring(0, 1), ended::add);

  @Test
  void set_asManyAsAllowed_nobodyIsEnded() {
    unfinished.set("a1", 60);
    unfinished.set("b1", 40);
    unfinished.set("a1", 60);

    assertThat(ended).isEmpty();
  }

  @Test
  void set_tooMany_endsTheLargestOfTheUserWithTheMost() {
    unfinished.set("b1", 45);
    unfinished.set("a1", 20);
    unfinished.set("a2", 30);
    unfinished.set("a1", 26);

    assertThat(ended).containsExactly("a2");
  }

  @Test
  void set_packetsBecomeComplete_makesRoom() {
    for (int i = 0; i < 10; i++) {
      unfinished.set("a1", 90);
      unfinished.set("a1", 0);
      unfinished.set("b1", 90);
      unfinished.set("b1", 0);
      unfinished.set("b1", 0);
    }

    assertThat(ended).isEmpty();
  }

  @Test
  void set_afterOneWasEnded_itsBytesNoLongerCount() {
    unfinished.set("a1", 101);
    unfinished.set("a1", 0);
    unfinished.set("b1", 100);
    assertThat(ended).containsExactly("a1");

    unfinished.set("c1", 1);
    assertThat(ended).containsExactly("a1", "b1");
  }
}
