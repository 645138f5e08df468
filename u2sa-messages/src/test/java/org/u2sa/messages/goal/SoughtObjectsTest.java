package org.u2sa.messages.goal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SoughtObjectsTest {
  private static GoalInformation seeking(String type) {
    return new ObjectGoal().objectType(type).within(1.0).uid(type);
  }

  @Test
  void of_goalsThatNameTypes_areAllOfThem() {
    GoalList goals = new GoalList().goals(List.of(seeking("red buoy"), seeking("dock")));

    assertThat(SoughtObjects.of(goals)).containsExactlyInAnyOrder("dock", "red buoy");
  }

  @Test
  void of_aGoalThatNamesNone_isEmptySinceItMayNeedAnything() {
    GoalInformation waypoint = new Waypoint().x(10.0).y(54.0).uid("home");
    GoalList goals = new GoalList().goals(List.of(seeking("red buoy"), waypoint));

    assertThat(SoughtObjects.of(goals)).isEmpty();
  }
}
