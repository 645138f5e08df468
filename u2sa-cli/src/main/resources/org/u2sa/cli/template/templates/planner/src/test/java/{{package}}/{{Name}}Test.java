package {{package}};

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.planning.PathPlanner;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

class {{Name}}Test {
  private final ServiceKit kit = new ServiceKit();

  @BeforeEach
  void goal_tenMetresNorth() {
    kit.start(PathPlanner::new); // finds the state under test by itself
    Waypoint north = new Waypoint().uid("north").referenceFrame(ReferenceFrame.LOCAL_NED);
    north.x(10.0).y(0.0).horizontalThreshold(0.5);
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(north)));
  }

  @AfterEach
  void close() {
    kit.close();
  }

  private NavigationPoint pointFrom(double northM) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    kit.advance(0.1);
    kit.publish(Channels.STATE, state.x(northM).y(0.0).psi(0.0));
    return kit.latest(Channels.NAVIGATION).orElseThrow();
  }

  @Test
  void plan_farFromTheWaypoint_leadsStraightToIt() {
    assertThat(pointFrom(0.0).point().x()).isEqualTo(10.0);
    assertThat(pointFrom(0.0).speed()).isEmpty();
  }

  @Test
  void plan_nearTheWaypoint_isSlow() {
    assertThat(pointFrom(9.0).speed()).hasValue(0.5);
  }

  @Test
  void plan_atTheWaypoint_reportsIt() {
    pointFrom(9.7);
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
  }

  @Test
  void mission_ofTheSimulatedRover_isCompleted(@TempDir Path logs) throws InterruptedException {
    assertThat(Drive.completed("config/{{file}}/system.xml", logs, 3, 120.0))
        .containsExactly("north", "north-east", "east");
  }
}
