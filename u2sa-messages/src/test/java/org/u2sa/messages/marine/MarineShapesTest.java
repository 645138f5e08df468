package org.u2sa.messages.marine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Geometry of hoops and docks. */
class MarineShapesTest {
  private static final double TINY = 1e-6;

  private static <T extends ObjectDescription> T placed(T object) {
    object.uid("1").referenceFrame(ReferenceFrame.LOCAL_ENU).x(10.0).y(20.0).z(2.0);
    return object;
  }

  private static Dock dock() {
    return placed(new Dock().length(4.0).width(3.0).height(0.5).thickness(0.5).psi(0.0));
  }

  @Test
  void distanceTo_uprightHoop_isToItsTube() {
    Hoop hoop = placed(new Hoop().radius(0.5).thickness(0.04).psi(0.0));

    assertThat(hoop.distanceTo(Point.of(10.0, 20.0, 2.0))).isEqualTo(0.48, within(TINY));
    assertThat(hoop.distanceTo(Point.of(10.0, 20.5, 2.0))).isZero();
    assertThat(hoop.distanceTo(Point.of(10.0, 20.0, 3.0))).isEqualTo(0.48, within(TINY));
    assertThat(hoop.distanceTo(Point.of(11.0, 20.5, 2.0))).isEqualTo(0.98, within(TINY));
  }

  @Test
  void distanceTo_lyingHoop_isToItsTube() {
    Hoop ring = placed(new Hoop().radius(1.0).thickness(0.1).lying(true));

    assertThat(ring.distanceTo(Point.of(10.0, 20.0, 2.0))).isEqualTo(0.95, within(TINY));
    assertThat(ring.distanceTo(Point.of(11.0, 20.0, 2.0))).isZero();
    assertThat(ring.distanceTo(Point.of(10.0, 21.0, 1.0))).isEqualTo(0.95, within(TINY));
  }

  @Test
  void outline_anyHoop_liesOnItsTube() {
    for (boolean lying : new boolean[] {true, false}) {
      Hoop hoop = placed(new Hoop().radius(0.5).psi(0.7).lying(lying));
      assertThat(hoop.outline(8)).hasSize(9);
      assertThat(hoop.outline(8))
          .allSatisfy(point -> assertThat(hoop.distanceTo(point)).isLessThan(TINY));
    }
  }

  @Test
  void distanceTo_dock_isToItsWallsAndTheBayIsFree() {
    Dock dock = dock();

    assertThat(dock.distanceTo(Point.of(10.0, 20.0, 2.0))).isEqualTo(1.0, within(TINY));
    assertThat(dock.distanceTo(Point.of(8.2, 20.0, 2.0))).isZero();
    assertThat(dock.distanceTo(Point.of(11.9, 21.4, 2.0))).isZero();
    assertThat(dock.distanceTo(Point.of(13.0, 20.0, 2.0))).isGreaterThan(1.0);
  }

  @Test
  void distanceTo_dockWithTheLongestUid_isThatOfAnyDock() {
    Dock dock = dock();
    dock.uid("d".repeat(1_000));

    assertThat(dock.distanceTo(Point.of(10.0, 20.0, 2.0))).isEqualTo(1.0, within(TINY));
  }

  @Test
  void in_bodyOfAVehicle_dockKeepsItsDistances() {
    StateInformation vehicle =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(15.0).y(12.0).psi(0.6);
    ObjectDescription seen = dock().in(ReferenceFrame.BODY, vehicle);

    // the vehicle itself, at east 12, north 15
    assertThat(seen.distanceTo(Point.ORIGIN))
        .isEqualTo(dock().distanceTo(Point.of(12.0, 15.0, 0.0)), within(1e-6));
    Hoop hoop = placed(new Hoop().radius(1.5).psi(0.4));
    assertThat(hoop.in(ReferenceFrame.BODY, vehicle).distanceTo(Point.ORIGIN))
        .isEqualTo(hoop.distanceTo(Point.of(12.0, 15.0, 0.0)), within(1e-6));
  }
}
