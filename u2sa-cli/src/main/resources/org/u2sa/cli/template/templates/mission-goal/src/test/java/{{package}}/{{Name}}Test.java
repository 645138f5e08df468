package {{package}};

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.planning.PathPlanner;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

class {{Name}}Test {
  @Test
  void plan_arrived_isCompletedAfterTheStay() {
    {{Name}} goal = new {{Name}}().stay(2.0);
    goal.uid("here")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(0.0)
        .y(0.0)
        .horizontalThreshold(0.5);
    try (ServiceKit kit = new ServiceKit()) {
      kit.start(PathPlanner::new);
      kit.publish(Channels.GOALS, new GoalList().goals(List.of(goal)));
      for (int seconds = 0; seconds < 2; seconds++) {
        kit.publish(Channels.STATE, standing());
        kit.advance(1.0);
      }
      assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
      kit.publish(Channels.STATE, standing());
      assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    }
  }

  private static StateInformation standing() {
    return new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).psi(0.0);
  }

  @Test
  void mission_ofTheSimulatedRover_isCompleted(@TempDir Path logs) throws InterruptedException {
    assertThat(Drive.completed("config/{{file}}/system.xml", logs, 3, 120.0))
        .containsExactly("north", "stay", "east");
  }
}
