package org.u2sa.scenarios.roboboat.subvehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.Plan;
import org.u2sa.planning.Pursuit;

class AwaitStateTest {
  private final AwaitState await = new AwaitState();

  private static Pursuit at(double timeS) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    state.timestamp(Math.round(timeS * 1e6));
    return new Pursuit(new FetchGoal().limit(60.0), Optional.empty(), Optional.empty(), state);
  }

  @Test
  void plan_whileTheSubVehicleMayBeOut_pressesSlowlyAhead() {
    await.enter(at(10.0));
    Plan plan = await.plan(at(100.0));

    assertThat(plan.progress()).isEqualTo(Plan.Progress.UNDER_WAY);
    NavigationPoint point = plan.points().get(0);
    assertThat(point.point().x()).isPositive();
    assertThat(point.speed().orElseThrow()).isBetween(0.1, 0.5);
    assertThat(point.turn()).hasValue(0.0);
  }

  @Test
  void plan_noReportAfterItsLimit_givesUpAndSaysWhy() {
    await.enter(at(10.0));
    Plan plan = await.plan(at(111.0));

    assertThat(plan.progress()).isEqualTo(Plan.Progress.ABANDONED);
    assertThat(plan.remark()).isEqualTo("given up: no report from the sub-vehicle for 101 s");
  }
}
