package org.u2sa.planning.goals;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;

/** Start of the mission by the goal lists of a Mission Manager. */
class MissionTimeTest {
  private final MissionTime time = new MissionTime();

  private static GoalList goals() {
    return new GoalList().goals(List.of(new Waypoint().uid("1")));
  }

  @Test
  void elapsedS_noList_isZero() {
    assertThat(time.elapsedS(5_000_000L)).isZero();
  }

  @Test
  void update_goalsWithoutTime_countsFromTheFirstOnes() {
    time.update(goals(), 1_000_000L);
    time.update(goals(), 2_000_000L);

    assertThat(time.elapsedS(4_000_000L)).isEqualTo(3.0);
  }

  @Test
  void update_elapsedTime_countsFromThatLongBeforeTheList() {
    GoalList list = goals().elapsed(10.0);
    list.timestamp(20_000_000L);
    time.update(list, 21_000_000L);

    assertThat(time.elapsedS(25_000_000L)).isEqualTo(15.0);
  }

  @Test
  void update_listFromTheFuture_countsFromItsArrival() {
    GoalList list = goals().elapsed(10.0);
    list.timestamp(50_000_000L);
    time.update(list, 21_000_000L);

    assertThat(time.elapsedS(21_000_000L)).isEqualTo(10.0);
  }

  @Test
  void update_noGoals_startsAgainWithTheNext() {
    time.update(goals(), 1_000_000L);
    time.update(new GoalList().goals(List.of()), 2_000_000L);
    time.update(goals(), 3_000_000L);

    assertThat(time.elapsedS(4_000_000L)).isEqualTo(1.0);
  }
}
