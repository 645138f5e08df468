package org.u2sa.sim.file;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Pose of a sensor on its vehicle.
 *
 * @param place forward, right, down of the reference point [m]
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

  /**
   * State at the sensor's position. Its acceleration omits the term due to the vehicle's angular
   * acceleration.
   */
  VehicleTruth of(VehicleTruth vehicle) {
    if (place.equals(Point.ORIGIN) && turn.equals(Point.ORIGIN)) {
      return vehicle;
    }
    Rotation nedFromFrd = vehicle.attitude().nedFromFrd();
    Point turning = vehicle.rates().cross(place);
    Rotation own = Rotation.nedFromFrd(turn.x(), turn.y(), turn.z());
    return new VehicleTruth(
        vehicle.timeS(),
        vehicle.position().plus(nedFromFrd.times(place).axesExchanged()),
        turn.equals(Point.ORIGIN) ? vehicle.attitude() : Attitude.of(nedFromFrd.times(own)),
        vehicle.velocity().plus(nedFromFrd.times(turning).axesExchanged()),
        own.transposed().times(vehicle.rates()),
        vehicle
            .acceleration()
            .plus(nedFromFrd.times(vehicle.rates().cross(turning)).axesExchanged()));
  }
}
