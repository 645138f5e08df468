package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.MovingSphere;

class MoverTest {
  private static final double[] NORTHS = {0.0, 2.0, 6.0};
  private static final double[] EASTS = {0.0, 0.0, 1.0};

  private static Mover mover(double stepS) {
    return new Mover("walker", 0L, stepS, NORTHS, EASTS, 1.0, 0.0, 0.5);
  }

  private static MovingSphere sphere() {
    MovingSphere sphere =
        new MovingSphere()
            .timeStep(2.0)
            .trajectory(List.of(Point.of(2.0, 0.0, 0.0), Point.of(6.0, 1.0, 0.0)));
    sphere.radius(0.5).uid("walker").referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0);
    return sphere;
  }

  private static Mover seen(MovingSphere sphere) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    state.x(0.0).y(0.0).psi(0.0);
    return new ObjectReader(PlanningPlane.at(state), state).mover(sphere, 0L).orElseThrow();
  }

  @Test
  void after_withinTheWay_isInterpolatedAndThenGoesOn() {
    assertThat(mover(2.0).northAfterM(1.0)).isEqualTo(1.0);
    assertThat(mover(2.0).northAfterM(3.0)).isEqualTo(4.0);
    assertThat(mover(2.0).northAfterM(5.0)).isEqualTo(7.0);
  }

  @Test
  void after_withoutTimeStep_startsWhereItWasSeen() {
    assertThat(mover(0.0).northAfterM(0.0)).isEqualTo(0.0);
    assertThat(mover(0.0).northAfterM(3.0)).isEqualTo(3.0);
    assertThat(mover(0.0).eastAfterM(3.0)).isEqualTo(0.0);
  }

  @Test
  void after_anyTime_isWhereTheMessageSays() {
    for (double stepS : new double[] {0.0, 2.0}) {
      MovingSphere sphere = sphere().timeStep(stepS);
      sphere.motion().velocity(Point.of(1.0, 0.5, 0.0));
      for (double seconds = 0.0; seconds < 8.0; seconds += 0.5) {
        Point expected = sphere.centerAfter(seconds);
        Mover mover = seen(sphere);
        assertThat(mover.northAfterM(seconds)).isCloseTo(expected.x(), within(1e-9));
        assertThat(mover.eastAfterM(seconds)).isCloseTo(expected.y(), within(1e-9));
      }
    }
  }

  @Test
  void mover_wayWithoutVelocity_isTrafficOnThatWay() {
    Mover mover = seen(sphere());

    assertThat(mover.stands()).isFalse();
    assertThat(mover.northAfterM(3.0)).isEqualTo(4.0);
    assertThat(mover.northAfterM(6.0)).isEqualTo(10.0);
  }
}
