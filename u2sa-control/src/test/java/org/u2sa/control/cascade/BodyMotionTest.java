package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

class BodyMotionTest {
  private static final double TINY = 1e-9;
  private static final double EAST = Math.PI / 2.0;

  private static BodyMotion motion(StateInformation state) {
    return BodyMotion.of(state, OptionalDouble.empty(), 0.0).orElseThrow();
  }

  private static void assertNear(Point point, double x, double y, double z) {
    assertThat(point.x()).isCloseTo(x, within(TINY));
    assertThat(point.y()).isCloseTo(y, within(TINY));
    assertThat(point.z()).isCloseTo(z, within(TINY));
  }

  @Test
  void of_sameMotionInBothFrames_isTheSame() {
    StateInformation ned =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .xDot(1.0)
            .yDot(2.0)
            .zDot(0.5)
            .psi(EAST)
            .psiDot(0.25);
    StateInformation global =
        new StateInformation().xDot(2.0).yDot(1.0).zDot(-0.5).psi(EAST).psiDot(0.25);

    for (StateInformation state : new StateInformation[] {ned, global}) {
      assertNear(motion(state).velocity(), 2.0, -1.0, 0.5); // heading east: north is to the left
      assertNear(motion(state).rates(), 0.0, 0.0, 0.25);
    }
  }

  @Test
  void of_withoutYawRate_isTheHeadingsChange() {
    StateInformation state = new StateInformation().xDot(0.0).yDot(0.0).psi(0.05);

    BodyMotion motion =
        BodyMotion.of(state, OptionalDouble.of(2.0 * Math.PI - 0.05), 0.5).orElseThrow();

    assertThat(motion.rates().z()).isCloseTo(0.2, within(TINY));
  }

  @Test
  void speedThroughFluid_inACurrent_isThatOfTheFluid() {
    StateInformation state = new StateInformation().xDot(0.3).yDot(0.4).psi(0.0);

    assertThat(motion(state).speedThroughFluidMps(state)).isCloseTo(0.5, within(TINY));
    state.fluidxDot(2.0).fluidyDot(-1.0).fluidzDot(2.0);
    assertThat(motion(state).speedThroughFluidMps(state)).isCloseTo(3.0, within(TINY));
  }

  @Test
  void of_withoutHeadingOrVelocity_isUnknown() {
    StateInformation noHeading = new StateInformation().xDot(0.0).yDot(0.0);
    StateInformation noVelocity = new StateInformation().psi(0.0);

    assertThat(BodyMotion.of(noHeading, OptionalDouble.empty(), 0.0)).isEmpty();
    assertThat(BodyMotion.of(noVelocity, OptionalDouble.empty(), 0.0)).isEmpty();
  }

  @Test
  void displacement_onEarth_isNorthEastDown() {
    Geodetic from = new Geodetic(9.0, 54.0, 20.0);
    Geodetic to = from.fromNed(Point.of(3.0, -4.0, 2.0));
    StateInformation then = state(from);
    StateInformation now = state(to);

    Point gone = BodyMotion.displacement(then, now).orElseThrow();

    assertThat(gone.x()).isCloseTo(3.0, within(1e-3));
    assertThat(gone.y()).isCloseTo(-4.0, within(1e-3));
    assertThat(gone.z()).isCloseTo(2.0, within(1e-3));
    assertThat(BodyMotion.displacement(then, new StateInformation())).isEmpty();
    StateInformation local =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).z(0.0);
    assertThat(BodyMotion.displacement(local, now)).isEmpty();
    assertThat(BodyMotion.displacement(now, local)).isEmpty();
  }

  private static StateInformation state(Geodetic place) {
    return new StateInformation()
        .x(place.longitudeDeg())
        .y(place.latitudeDeg())
        .z(place.altitudeM());
  }

  @Test
  void costs_asWritten_areReadAndBadOnesNamed() {
    assertThat(Costs.parse("THRUSTER 1 4, BOW THRUSTER 2.5"))
        .containsEntry("THRUSTER 1", 4.0)
        .containsEntry("BOW THRUSTER", 2.5);
    assertThat(Costs.parse("")).isEmpty();
    assertThatThrownBy(() -> Costs.parse("THRUSTER x"))
        .hasMessageContaining("COSTS: \"THRUSTER x\"");
    assertThatThrownBy(() -> Costs.parse("THRUSTER 0")).hasMessageContaining("above 0");
  }
}
