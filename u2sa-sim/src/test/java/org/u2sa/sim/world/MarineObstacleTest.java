package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;

/** Rays and footprints against objects of marine courses. */
class MarineObstacleTest {
  private static Obstacle at(ObjectDescription object) {
    object.uid("1").referenceFrame(ReferenceFrame.LOCAL_ENU).x(10.0).y(0.0).z(1.0);
    return Obstacle.of(object, null);
  }

  private static Prism square(double x, double y, double half) {
    return new Prism(
        new double[] {x - half, x + half, x + half, x - half},
        new double[] {y - half, y - half, y + half, y + half},
        0.8,
        1.2);
  }

  @Test
  void distanceM_buoy_isThatOfASphere() {
    assertThat(at(new Buoy().radius(0.5)).distanceM(new Ray(0.0, 0.0, 1.0, 1.0, 0.0, 0.0)))
        .isEqualTo(9.5, within(1e-9));
  }

  @Test
  void distanceM_hoop_raysPassThroughItsMiddleAndMeetItsTube() {
    Obstacle hoop = at(new Hoop().radius(0.5).thickness(0.1));

    assertThat(hoop.distanceM(new Ray(0.0, 0.0, 1.0, 1.0, 0.0, 0.0))).isInfinite();
    assertThat(hoop.distanceM(new Ray(0.0, 0.5, 1.0, 1.0, 0.0, 0.0))).isEqualTo(10.0);
    assertThat(hoop.touches(square(10.0, 0.0, 0.3))).isFalse();
    assertThat(hoop.touches(square(10.0, 0.4, 0.3))).isTrue();
  }

  @Test
  void touches_dock_onlyOutsideItsBay() {
    Obstacle dock = at(new Dock().length(4.0).width(3.0).height(1.0).thickness(0.5).psi(0.0));

    assertThat(dock.touches(square(10.5, 0.0, 0.9))).isFalse();
    assertThat(dock.touches(square(8.5, 0.0, 0.5))).isTrue();
    assertThat(dock.touches(square(12.0, 1.3, 0.3))).isTrue();
    assertThat(dock.distanceM(new Ray(20.0, 0.0, 1.0, -1.0, 0.0, 0.0)))
        .isEqualTo(11.5, within(1e-9));
  }
}
