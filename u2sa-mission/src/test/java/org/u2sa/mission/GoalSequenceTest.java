package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.GoalSequence.Options;

class GoalSequenceTest {
  /** Goals written as "a→b,c d": names, each with what may come next. */
  private static GoalSequence sequence(String goals, boolean loop, Options options) {
    List<GoalInformation> list = new ArrayList<>();
    for (String goal : goals.split(" ")) {
      String[] parts = goal.split("→");
      list.add(goal(parts[0], parts.length > 1 ? List.of(parts[1].split(",")) : List.of()));
    }
    return new GoalSequence(list, loop, options);
  }

  private static Waypoint goal(String name, List<String> next) {
    Waypoint goal = new Waypoint().uid(name).next(next).x(1.0).horizontalThreshold(5.0);
    goal.freeze();
    return goal;
  }

  private static String names(List<GoalInformation> goals) {
    return goals.stream().map(GoalInformation::uid).collect(Collectors.joining(","));
  }

  /** What is current after each of the goals was finished, separated by blanks. */
  private static String run(GoalSequence sequence, String... finished) {
    StringBuilder seen = new StringBuilder(names(sequence.current()));
    for (String goal : finished) {
      assertThat(sequence.finish(goal)).as(goal).isTrue();
      seen.append(' ').append(names(sequence.current()));
    }
    return seen.toString();
  }

  @Test
  void finish_noNextAnywhere_followsTheFile() {
    assertThat(run(sequence("a b c", false, Options.ALL), "a", "b", "c")).isEqualTo("a b c ");
  }

  @Test
  void finish_noNextAnywhereAndLoop_beginsAnew() {
    assertThat(run(sequence("a b", true, Options.ALL), "a", "b", "a", "b")).isEqualTo("a b a b a");
  }

  @Test
  void finish_next_followsTheNames() {
    assertThat(run(sequence("a→c b c→b", false, Options.ALL), "a", "c", "b")).isEqualTo("a c b ");
  }

  @Test
  void finish_lastNextNamesTheFirst_loopsForEver() {
    assertThat(run(sequence("a→b b→c c→a", false, Options.ALL), "a", "b", "c", "a", "b"))
        .isEqualTo("a b c a b c");
  }

  @Test
  void finish_severalNextAll_allAreDoneBeforeWhatFollows() {
    GoalSequence sequence = sequence("a→b,c b→d c→d d", false, Options.ALL);

    assertThat(run(sequence, "a", "c", "b", "d")).isEqualTo("a b,c b d ");
  }

  @Test
  void finish_severalNextAny_theFinishedOneLeads() {
    GoalSequence sequence = sequence("a→b,c b→d c→e d e", false, Options.ANY);

    assertThat(run(sequence, "a", "c", "e")).isEqualTo("a b,c e ");
  }

  @Test
  void finish_nextNamesFinishedGoals_theseAreNotOfferedAgain() {
    GoalSequence any = sequence("a→b,c b→c,d c→b,d d", false, Options.ANY);
    GoalSequence all = sequence("a→b b→a,c c", false, Options.ALL);

    assertThat(run(any, "a", "b", "c", "d")).isEqualTo("a b,c c,d d ");
    assertThat(run(all, "a", "b", "c")).isEqualTo("a b c ");
  }

  @Test
  void finish_graphEndsAndLoop_beginsWithTheFirst() {
    assertThat(run(sequence("a→b b", true, Options.ALL), "a", "b", "a")).isEqualTo("a b a b");
  }

  @Test
  void finish_goalThatIsNotCurrent_isRefused() {
    GoalSequence sequence = sequence("a b", false, Options.ALL);

    assertThat(sequence.finish("b")).isFalse();
    assertThat(names(sequence.current())).isEqualTo("a");
  }

  @Test
  void upcoming_oneCurrent_isWhatFollows() {
    GoalSequence sequence = sequence("a→b,c b c", false, Options.ALL);

    assertThat(names(sequence.upcoming())).isEqualTo("b,c");
    assertThat(names(sequence.current())).isEqualTo("a");
    run(sequence, "a");
    assertThat(names(sequence.upcoming())).isEmpty();
  }

  @Test
  void upcoming_severalCurrentAny_isWhatFollowsEach() {
    GoalSequence sequence = sequence("a→b,c b→d c→e d e", false, Options.ANY);
    run(sequence, "a");

    assertThat(names(sequence.upcoming())).isEqualTo("d,e");
  }

  @Test
  void changeTo_goal_goesOnFromThere() {
    GoalSequence sequence = sequence("a b c d", false, Options.ALL);
    run(sequence, "a", "b");
    sequence.changeTo("a");

    assertThat(run(sequence, "a", "b", "c", "d")).isEqualTo("a b c d ");
  }

  @Test
  void changeTo_afterTheEnd_isUnderWayAgain() {
    GoalSequence sequence = sequence("a b", false, Options.ALL);
    run(sequence, "a", "b");
    sequence.changeTo("b");

    assertThat(sequence.isOver()).isFalse();
  }

  @Test
  void update_knownGoal_takesOverWhatIsSetAndKeepsTheRest() {
    GoalSequence sequence = sequence("a b", false, Options.ALL);

    assertThat(sequence.update(new Waypoint().uid("a").y(7.0).horizontalThreshold(9.0))).isTrue();
    Waypoint updated = (Waypoint) sequence.current().get(0);
    assertThat(updated.x()).hasValue(1.0);
    assertThat(updated.y()).hasValue(7.0);
    assertThat(updated.horizontalThreshold()).isEqualTo(9.0);
  }

  @Test
  void update_newGoal_isPursuedOnceAnotherPointsToIt() {
    GoalSequence sequence = sequence("a b c", false, Options.ALL);

    assertThat(sequence.update(goal("x", List.of("c")))).isFalse();
    assertThat(names(sequence.upcoming())).isEqualTo("b");
    sequence.update(goal("a", List.of("x")));
    assertThat(run(sequence, "a", "x", "c")).isEqualTo("a x c ");
  }

  @Test
  void update_newGoalNobodyPointsTo_isNeverPursued() {
    GoalSequence sequence = sequence("a b", false, Options.ALL);
    sequence.update(goal("x", List.of()));

    assertThat(run(sequence, "a", "b")).isEqualTo("a b ");
  }
}
