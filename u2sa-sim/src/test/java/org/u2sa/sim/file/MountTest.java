package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Iterator;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

class MountTest {
  private static final VehicleTruth EASTBOUND =
      new VehicleTruth(
          0.0,
          Point.of(10.0, 20.0, 0.0),
          new Attitude(0.0, 0.0, Math.PI / 2.0),
          Point.of(3.0, 0.0, 0.0),
          Point.of(0.0, 0.0, 0.5),
          Point.ORIGIN);

  private static void assertClose(Point actual, double x, double y, double z) {
    assertThat(actual.distanceTo(Point.of(x, y, z))).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void of_sensorAheadOfATurningVehicle_hasItsOwnPlaceVelocityAndAcceleration() {
    VehicleTruth sensor = new Mount(Point.of(2.0, 0.0, -1.0), Point.ORIGIN).of(EASTBOUND);

    assertClose(sensor.position(), 12.0, 20.0, 1.0);
    assertClose(sensor.velocity(), 3.0, -1.0, 0.0); // ω × r = 0.5 · 2 to the right, south
    assertClose(sensor.acceleration(), -0.5, 0.0, 0.0); // ω² r towards the vehicle
  }

  @Test
  void following_vehicleThatTurnsFaster_acceleratesAlongTheArc() {
    VehicleTruth faster =
        new VehicleTruth(
            0.1,
            EASTBOUND.position(),
            EASTBOUND.attitude(),
            EASTBOUND.velocity(),
            Point.of(0.0, 0.0, 0.7),
            Point.ORIGIN);
    Iterator<VehicleTruth> states = List.of(EASTBOUND, faster).iterator();
    Supplier<VehicleTruth> sensor =
        new Mount(Point.of(2.0, 0.0, 0.0), Point.ORIGIN).following(states::next);

    assertClose(sensor.get().acceleration(), -0.5, 0.0, 0.0); // no rate to compare with
    assertClose(sensor.get().acceleration(), -0.98, -4.0, 0.0); // 2 rad/s² · 2 m to the right
  }

  @Test
  void of_sensorThatLooksRight_hasThatHeading() {
    VehicleTruth sensor = new Mount(Point.ORIGIN, Point.of(0.0, 0.0, Math.PI / 2.0)).of(EASTBOUND);

    assertThat(sensor.headingRad()).isCloseTo(Math.PI, within(1e-9));
  }

  @Test
  void of_sensorAtTheReferencePoint_isTheVehicleItself() {
    assertThat(new Mount(Point.ORIGIN, Point.ORIGIN).of(EASTBOUND)).isSameAs(EASTBOUND);
  }
}
