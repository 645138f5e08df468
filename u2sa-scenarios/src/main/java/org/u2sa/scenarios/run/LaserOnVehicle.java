package org.u2sa.scenarios.run;

import java.util.function.Supplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.World;

/**
 * Ranges of a horizontally mounted lidar that tilts with the vehicle.
 *
 * @param forwardM mounting position ahead of the vehicle's reference point [m]
 * @param upM height above it [m]
 * @param rangeM maximum range [m]
 */
public record LaserOnVehicle(
    World world, Supplier<VehicleTruth> truth, double forwardM, double upM, double rangeM)
    implements Supplier<SimulatedLaser.Sight> {
  @Override
  public SimulatedLaser.Sight get() {
    VehicleTruth now = truth.get();
    Rotation nedFromFrd = now.attitude().nedFromFrd();
    Point ned = nedFromFrd.times(Point.of(forwardM, 0.0, -upM));
    Point from = now.position().plus(Point.of(ned.y(), ned.x(), -ned.z()));
    return (angleRad, cos, sin) -> {
      Point way = nedFromFrd.times(Point.of(cos, -sin, 0.0));
      Ray ray = new Ray(from.x(), from.y(), from.z(), way.y(), way.x(), -way.z());
      return world.distanceM(ray, rangeM);
    };
  }
}
