package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.u2sa.sim.atmosphere.Wind;

class ControlInputsTest {
  @Test
  void new_notANumber_isRefusedByName() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ControlInputs.neutral().withSurfaces(0.0, Double.NaN, 0.0))
        .withMessage("elevator: NaN is outside -1.0…1.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ControlInputs.limited(0, 0, 0, Double.POSITIVE_INFINITY, 1, 0, 0, 0))
        .withMessage("throttle: Infinity is not a number");
  }

  @Test
  void new_outOfRange_isRefusedByName() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ControlInputs.neutral().withThrottle(-0.1))
        .withMessage("throttle: -0.1 is outside 0.0…1.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ControlInputs.neutral().withBrakes(0.0, 1.1))
        .withMessage("brakeRight: 1.1 is outside 0.0…1.0");
  }

  @Test
  void limited_outOfRange_isMovedInside() {
    assertThat(ControlInputs.limited(-3, 2, -1.5, 7, -1, 9, -9, 2))
        .isEqualTo(new ControlInputs(-1, 1, -1, 1, 0, 1, 0, 1));
  }

  @Test
  void starts_badNumbers_areRefusedByName() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new RunwayStart(0.0, 95.0, 0.0, 0.0))
        .withMessage("start latitude [deg]: 95.0 is outside -85.0…85.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new RunwayStart(0.0, 5.0, Double.NaN, 0.0))
        .withMessageContaining("start elevation [m]: NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new FlightStart(0, 0, 100, 200, 0, 50, 0, 0, 0, 0, 2000, 0))
        .withMessageContaining("ground elevation [m]: 200.0");
  }

  @Test
  void step_badTime_isRefused() {
    Cessna172 aircraft = Cessna172.onRunway(new RunwayStart(0.0, 0.0, 0.0, 0.0), Wind.calm(), true);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> aircraft.step(ControlInputs.neutral(), Double.NaN))
        .withMessageContaining("dt: NaN s");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> aircraft.step(ControlInputs.neutral(), 0.0));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> aircraft.step(ControlInputs.neutral(), 61.0));
  }
}
