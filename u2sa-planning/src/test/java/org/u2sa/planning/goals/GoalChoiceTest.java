package org.u2sa.planning.goals;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;

class GoalChoiceTest {
  private final Waypoint a = new Waypoint().uid("a").next(List.of("d"));
  private final Waypoint b = new Waypoint().uid("b").next(List.of("c"));
  private final Waypoint c = new Waypoint().uid("c");
  private final Waypoint d = new Waypoint().uid("d");

  private static double alike(GoalInformation goal) {
    return 1.0;
  }

  @Test
  void goal_preferredIsCurrent_isKeptThoughOthersAreNearer() {
    GoalChoice choice = new GoalChoice(new GoalList().goals(List.of(a, b)).upcoming(List.of()));

    assertThat(choice.goal("b", goal -> goal == a ? 1.0 : 9.0)).containsSame(b);
    assertThat(choice.goal("gone", goal -> goal == a ? 9.0 : 1.0)).containsSame(b);
  }

  @Test
  void after_severalCurrent_isWhatTheChosenOneNames() {
    GoalChoice choice = new GoalChoice(new GoalList().goals(List.of(a, b)).upcoming(List.of(c, d)));

    assertThat(choice.after(a, "", GoalChoiceTest::alike)).containsSame(d);
    assertThat(choice.after(b, "", GoalChoiceTest::alike)).containsSame(c);
  }

  @Test
  void after_severalCurrentAndNothingUpcoming_isAnotherOfThem() {
    GoalChoice choice = new GoalChoice(new GoalList().goals(List.of(a, b)).upcoming(List.of()));

    assertThat(choice.after(a, "", GoalChoiceTest::alike)).containsSame(b);
  }
}
