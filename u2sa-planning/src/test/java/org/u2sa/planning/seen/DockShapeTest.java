package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Dock;

class DockShapeTest {
  private static final double WIDTH_M = 3.0;

  private static PlanarShape shape(Dock dock) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    state.x(0.0).y(0.0).psi(0.0);
    dock.uid("dock").referenceFrame(ReferenceFrame.LOCAL_NED).x(10.0).y(0.0).z(0.0);
    return new ObjectReader(PlanningPlane.at(state), state).shape(dock);
  }

  @Test
  void shape_bayIsKnown_isItsWalls() {
    Dock dock = new Dock().length(4.0).width(WIDTH_M).thickness(0.5).psi(Math.PI);

    assertThat(shape(dock).distanceM(10.0, 0.0)).as("in the bay").isGreaterThan(0.9);
    assertThat(shape(dock).distanceM(14.0, 0.0)).as("behind").isCloseTo(2.0, within(1e-9));
  }

  @Test
  void shape_onlyItsWidthIsKnown_isSolid() {
    Dock dock = new Dock().width(WIDTH_M);

    assertThat(shape(dock).distanceM(10.0, 0.5)).isNotPositive();
    assertThat(shape(dock).distanceM(14.0, 0.0)).isCloseTo(2.5, within(1e-9));
  }
}
