package org.u2sa.scenarios.vrx;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.marine.Colour;
import org.u2sa.testkit.ServiceKit;

class LightReaderTest {
  private static final List<Colour> SHOWN = List.of(Colour.RED, Colour.GREEN, Colour.RED);

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void end() {
    kit.close();
  }

  /** A buoy that changes its colour each second, seen from a time on, with wrong looks. */
  private static Optional<Colour> shown(double timeS, double fromS, double wrong, Random random) {
    int state = (int) (timeS % 5.0);
    if (timeS < fromS || state >= SHOWN.size()) {
      return Optional.empty();
    }
    return Optional.of(random.nextDouble() < wrong ? Colour.BLUE : SHOWN.get(state));
  }

  private List<GoalInformation> read(double fromS, double wrong, double seconds) {
    Random random = new Random(3);
    kit.start(context -> new LightReader(context, timeS -> shown(timeS, fromS, wrong, random)));
    GoalInformation goal = new DockBySign().duration(11.0).uid("dock");
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(goal)));
    kit.advance(seconds);
    return kit.published(Channels.GOAL_UPDATES);
  }

  @Test
  void step_twoReadingsThatAgree_enterTheSequence() {
    List<GoalInformation> updates = read(0.0, 0.2, 20.0);

    assertThat(updates).hasSize(1);
    assertThat(updates.get(0).uid()).isEqualTo("dock");
    assertThat(((DockBySign) updates.get(0)).sequence()).isEqualTo(SHOWN);
  }

  @Test
  void step_firstSeenInTheMiddle_waitsForAWholeSequence() {
    assertThat(read(1.5, 0.0, 9.9)).isEmpty();
  }

  @Test
  void step_readingsThatDiffer_areNotEntered() {
    assertThat(read(0.0, 0.9, 11.0)).noneMatch(goal -> sequence(goal).equals(SHOWN));
  }

  private static List<Colour> sequence(GoalInformation goal) {
    return ((DockBySign) goal).sequence();
  }
}
