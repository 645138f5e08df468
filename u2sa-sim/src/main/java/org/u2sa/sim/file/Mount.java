package org.u2sa.sim.file;

import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Pose of a sensor on its vehicle.
 *
 * @param place position relative to the reference point: forward, right, down [m]
 * @param turn roll, pitch and yaw of the sensor relative to the vehicle [rad]
 */
record Mount(Point place, Point turn) {
  private static final double FAR_M = 1_000.0;

  /** Reads {@code <position>}. */
  static Mount place(FileElement sensor) {
    return new Mount(sensor.vector("position", "m", -FAR_M, FAR_M, Point.ORIGIN), Point.ORIGIN);
  }

  /** Reads {@code <position>} and {@code <orientation>}. */
  static Mount pose(FileElement sensor) {
    return new Mount(
        place(sensor).place, sensor.vector("orientation", "rad", -Math.PI, Math.PI, Point.ORIGIN));
  }

  /** State at the sensor's position while the vehicle turns at a constant rate. */
  VehicleTruth of(VehicleTruth vehicle) {
    return of(vehicle, Point.ORIGIN);
  }

  /**
   * Current states at the position of one sensor. The angular acceleration in them is the mean
   * since the previous state, as measured by a sensor that averages between readings.
   */
  Supplier<VehicleTruth> following(Supplier<VehicleTruth> vehicle) {
    AtomicReference<VehicleTruth> previous = new AtomicReference<>();
    return () -> {
      VehicleTruth now = vehicle.get();
      VehicleTruth before = Objects.requireNonNullElse(previous.getAndSet(now), now);
      double seconds = now.timeS() - before.timeS();
      Point turned = now.rates().minus(before.rates());
      return of(now, seconds > 0.0 ? turned.times(1.0 / seconds) : Point.ORIGIN);
    };
  }

  private VehicleTruth of(VehicleTruth vehicle, Point angularAcceleration) {
    if (place.equals(Point.ORIGIN) && turn.equals(Point.ORIGIN)) {
      return vehicle;
    }
    Rotation nedFromFrd = vehicle.attitude().nedFromFrd();
    Point turning = vehicle.rates().cross(place);
    Point onArm = angularAcceleration.cross(place).plus(vehicle.rates().cross(turning));
    Rotation own = Rotation.nedFromFrd(turn.x(), turn.y(), turn.z());
    return new VehicleTruth(
        vehicle.timeS(),
        vehicle.position().plus(nedFromFrd.times(place).axesExchanged()),
        turn.equals(Point.ORIGIN) ? vehicle.attitude() : Attitude.of(nedFromFrd.times(own)),
        vehicle.velocity().plus(nedFromFrd.times(turning).axesExchanged()),
        own.transposed().times(vehicle.rates()),
        vehicle.acceleration().plus(nedFromFrd.times(onArm).axesExchanged()));
  }
}
