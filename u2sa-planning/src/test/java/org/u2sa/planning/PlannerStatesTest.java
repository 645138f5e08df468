package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;

class PlannerStatesTest {
  private final PlannerState any = new Fixed(GoalInformation.class);
  private final PlannerState waypoints = new Fixed(Waypoint.class);

  @Test
  void forGoal_subclassKnown_nearestClassWins() {
    assertThat(new PlannerStates(List.of(any, waypoints)).forGoal(new Waypoint()))
        .containsSame(waypoints);
    assertThat(new PlannerStates(List.of(waypoints, any)).forGoal(new Waypoint()))
        .containsSame(waypoints);
  }

  @Test
  void forGoal_onlyAncestorKnown_isTaken() {
    assertThat(new PlannerStates(List.of(any, waypoints)).forGoal(new Dance())).containsSame(any);
  }

  @Test
  void forGoal_sameClassTwice_theLaterReplaces() {
    PlannerState extension = new Fixed(Waypoint.class);

    assertThat(
            new PlannerStates(List.of(waypoints, extension)).forGoal(new Waypoint()).orElseThrow())
        .isSameAs(extension);
  }

  @Test
  void forGoal_noneKnown_isEmpty() {
    assertThat(new PlannerStates(List.of(waypoints)).forGoal(new Dance())).isEmpty();
  }

  @Test
  void substitution_onlyAnOwnStateOfAnAncestor_isToldOnce() {
    PlannerStates states = new PlannerStates(List.of(any));

    assertThat(states.substitution(new Dance().uid("a")).orElseThrow())
        .startsWith("goal \"a\": a Dance is pursued as a GoalInformation; expected a PlannerState")
        .endsWith("META-INF/services/org.u2sa.planning.PlannerStateProvider");
    assertThat(states.substitution(new Dance().uid("b"))).isEmpty();
    assertThat(new PlannerStates(List.of(waypoints)).substitution(new Waypoint())).isEmpty();
    assertThat(new PlannerStates(List.of()).substitution(new Dance())).isEmpty();
  }

  private record Fixed(Class<? extends GoalInformation> goalClass) implements PlannerState {
    @Override
    public void enter(Pursuit pursuit) {}

    @Override
    public Plan plan(Pursuit pursuit) {
      return Plan.underWay(List.of());
    }

    @Override
    public double distanceM(GoalInformation goal, StateInformation state) {
      return 0.0;
    }
  }
}
