package org.u2sa.sim.marine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Dock;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/**
 * A bay that is open to the west: its back wall begins at 11 m east, its fingers reach to 9 m east,
 * 1 m to either side.
 */
class FendersTest {
  private static final World HARBOUR =
      World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, 0.0, 0.0)).with(List.of(dock()));
  private static final Footprint HULL = Footprint.rectangle(0.5, 0.5, 0.6, -0.1, 0.3);
  private static final double EAST = Math.PI / 2.0;
  private static final Point STILL = Point.ORIGIN;

  private static Dock dock() {
    Dock dock = new Dock().length(2.5).width(3.0).height(6.0).thickness(0.5).psi(Math.PI);
    dock.uid("dock").referenceFrame(ReferenceFrame.LOCAL_ENU).x(10.25).y(0.0).z(0.0);
    return dock;
  }

  private static Point force(World world, Point place, double heading, Point velocity) {
    return new Fenders(world, HULL).on(new Fenders.Motion(place, heading, velocity, 0.0));
  }

  @Test
  void on_bow2CmInTheBackWall_isPushedBackAlongItsLength() {
    Point force = force(HARBOUR, Point.of(10.52, 0.0, 0.0), EAST, STILL);

    assertThat(force.x()).isCloseTo(-2 * 0.02 * 3_000.0, within(1e-6)); // at two corners
    assertThat(force.y()).isCloseTo(0.0, within(1e-9));
    assertThat(force.z()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void on_hullAcrossTheEndOfAFinger_isPushedOffAndTurned() {
    // heading north, the finger's end 0.2 m ahead of its middle and 1 cm in its right side
    Point force = force(HARBOUR, Point.of(8.71, -1.45, 0.0), 0.0, STILL);

    assertThat(force.y()).isNegative();
    assertThat(force.z()).as("bow away from the finger").isNegative();
  }

  @Test
  void on_hullLeavesTheWallFasterThanItSprings_isNotHeldBack() {
    Point force = force(HARBOUR, Point.of(10.52, 0.0, 0.0), EAST, Point.of(-1.0, 0.0, 0.0));

    assertThat(force).isEqualTo(Point.ORIGIN);
  }

  @Test
  void on_hullSlidesAlongTheWall_isBrakedByAFifthOfThePressure() {
    Point force = force(HARBOUR, Point.of(10.52, 0.0, 0.0), EAST, Point.of(0.0, 0.5, 0.0));

    assertThat(force.y())
        .as("to the right, as it slides to the left")
        .isCloseTo(24.0, within(1e-6));
  }

  @Test
  void on_hullInTheBayOrBelowTheDock_isFree() {
    assertThat(force(HARBOUR, Point.of(10.0, 0.5, 0.0), EAST, STILL)).isEqualTo(Point.ORIGIN);
    assertThat(force(HARBOUR, Point.of(10.52, 0.0, -4.0), EAST, STILL)).isEqualTo(Point.ORIGIN);
  }

  @Test
  void on_dockInGlobal_isThatInLocalEnu() {
    Geodetic at = HARBOUR.plane().at(10.25, 0.0, 0.0);
    Dock onEarth = new Dock().length(2.5).width(3.0).height(6.0).thickness(0.5).psi(-EAST);
    onEarth.uid("dock").referenceFrame(ReferenceFrame.GLOBAL);
    onEarth.x(at.longitudeDeg()).y(at.latitudeDeg()).z(at.altitudeM());
    Point place = Point.of(10.53, 0.72, 0.0);

    Point force = force(HARBOUR.with(List.of(onEarth)), place, 1.5, STILL);

    assertThat(force.distanceTo(force(HARBOUR, place, 1.5, STILL))).isLessThan(0.1);
    assertThat(force.distance()).isGreaterThan(10.0);
  }

  @Test
  void step_vesselRunsIntoTheBackWall_staysOutAndComesToRest() {
    Vessel vessel =
        new Vessel(
            BlueRov2.hull(), BlueRov2.thrusters(), HULL, HARBOUR, Point.of(8.0, 0.2, 0.0), EAST);
    for (int i = 1; i <= 4; i++) {
      vessel.command("THRUSTER " + i, 0.4);
    }
    double farthest = 0.0;
    for (int i = 0; i < 200; i++) {
      vessel.step(0.1);
      farthest = Math.max(farthest, vessel.truth().position().x());
    }
    VehicleTruth end = vessel.truth();

    assertThat(farthest).isBetween(10.5, 10.6);
    assertThat(end.position().x()).isCloseTo(10.5, within(0.02));
    assertThat(Math.hypot(end.velocity().x(), end.velocity().y())).isLessThan(0.02);
  }
}
