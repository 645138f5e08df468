package org.u2sa.scenarios.robosub;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

class SightStateTest {
  /** A camera that recognises nothing. */
  private static final PlannerView BLIND =
      (PlannerView)
          Proxy.newProxyInstance(
              SightStateTest.class.getClassLoader(),
              new Class<?>[] {PlannerView.class},
              (view, method, arguments) -> method.getName().equals("objects") ? List.of() : null);

  private double lastTravelS;

  /** Pursues a goal until it is given up, and tells when. */
  private double pursue(PlannerState state, double fromS) {
    state.enter(at(fromS));
    for (double timeS = fromS; ; timeS += 0.5) {
      Plan plan = state.plan(at(timeS));
      if (plan.progress() == Plan.Progress.ABANDONED) {
        return timeS;
      }
      if (plan.points().get(0).point().distance() > 1.0) {
        lastTravelS = timeS;
      }
    }
  }

  private static Pursuit at(double timeS) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    state.x(0.0).y(0.0).z(1.0).psi(0.0).timestamp(Math.round(timeS * 1e6));
    return new Pursuit(new BumpBuoy(), Optional.empty(), Optional.empty(), state);
  }

  @Test
  void plan_nothingSeenByAnyGoal_travelsBlindlyForFortySecondsAtMost() {
    TaskSight sight = new TaskSight(BLIND);

    double first = pursue(new BuoyState(sight), 0.0);
    double second = pursue(new RingState(sight), first);

    assertThat(lastTravelS).isBetween(10.0, 40.0);
    assertThat(second - first).isBetween(60.0, 61.0);
  }
}
