package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.testkit.ServiceKit;

/** An aeroplane that a wind holds up: its velocities are given, whatever it is led to. */
class HeadwayTest {
  private static final double STEP_S = 0.1;
  private static final double AIRSPEED_MPS = 22.0;

  private final ServiceKit kit = new ServiceKit();
  private PathPlanner planner;
  private Point ned = Point.of(0.0, 0.0, -80.0);

  @BeforeEach
  void plane() {
    kit.with("TURN ACCELERATION", 6.0).with("LOOK AHEAD", 50.0).with("LOITER RADIUS", 100.0);
    kit.with("AT END", "HOLD");
    planner = kit.start(PathPlanner::new);
  }

  @AfterEach
  void close() {
    kit.close();
  }

  private GoalList north() {
    Waypoint far = new Waypoint().x(2000.0).y(0.0).z(-80.0).horizontalThreshold(15.0);
    far.uid("W").referenceFrame(ReferenceFrame.LOCAL_NED);
    return new GoalList().goals(List.of(far));
  }

  /** Flies with a velocity over ground, nose to the north. */
  private void fly(double northMps, double eastMps, double forS) {
    for (double s = 0.0; s < forS - 1e-6; s += STEP_S) {
      kit.advance(STEP_S);
      ned = ned.plus(Point.of(northMps, eastMps, 0.0).times(STEP_S));
      kit.publish(
          Channels.STATE,
          new StateInformation()
              .referenceFrame(ReferenceFrame.LOCAL_NED)
              .x(ned.x())
              .y(ned.y())
              .z(ned.z())
              .xDot(northMps)
              .yDot(eastMps)
              .zDot(0.0)
              .phi(0.0)
              .theta(0.0)
              .psi(0.0)
              .fluidxDot(AIRSPEED_MPS)
              .fluidyDot(0.0)
              .fluidzDot(0.0));
    }
  }

  private List<GoalInformation> reports() {
    return kit.published(Channels.GOAL_REPORTS);
  }

  private List<String> warnings() {
    return kit.log("PathPlanner").stream().filter(line -> line.contains("no headway")).toList();
  }

  @Test
  void goal_aeroplaneDrivenBack_isReportedAndGivenUpWithTheWind() {
    kit.publish(Channels.GOALS, north());
    fly(20.0, 0.0, 10.0);
    fly(-3.0, 0.0, 28.0);
    assertThat(warnings()).isEmpty();
    fly(-3.0, 0.0, 4.0);
    assertThat(warnings()).hasSize(1);
    assertThat(warnings().get(0))
        .contains("goal \"W\": no headway for 30 s: -3.0 m/s on average, in 25 m/s of wind");
    HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
    assertThat(health.lastError().orElse("")).contains("no headway");
    assertThat(String.valueOf(health.remarks())).contains("headway");
    assertThat(reports()).isEmpty();
    fly(-3.0, 0.0, 32.0);

    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow())
        .isEqualTo("given up: no headway for 60 s: -3.0 m/s on average, in 25 m/s of wind");
  }

  @Test
  void goal_onTheWayHome_isReportedButPursued() {
    kit.publish(Channels.GOALS, north().returning(true));
    fly(20.0, 0.0, 10.0);
    fly(-3.0, 0.0, 200.0);

    assertThat(warnings()).hasSize(1);
    assertThat(reports()).isEmpty();
  }

  @Test
  void goal_turnsAwayAndLittleHeadway_isPursued() {
    kit.publish(Channels.GOALS, north());
    for (int i = 0; i < 5; i++) {
      fly(-20.0, 0.0, 15.0);
      fly(3.0, 0.0, 60.0);
    }

    assertThat(warnings()).isEmpty();
    assertThat(reports()).isEmpty();
  }

  @Test
  void hold_aeroplaneDrivenBack_isReportedOnce() {
    kit.publish(Channels.GOALS, north().paused(true));
    fly(20.0, 0.0, 5.0);
    fly(-15.0, 0.0, 200.0);

    assertThat(warnings()).hasSize(1);
  }

  @Test
  void goal_notWatched_isPursued() {
    kit.with("HEADWAY TIME", 0.0);
    kit.publish(Channels.GOALS, north());
    planner = kit.restart(planner, PathPlanner::new);
    fly(20.0, 0.0, 10.0);
    fly(-3.0, 0.0, 200.0);

    assertThat(warnings()).isEmpty();
  }
}
