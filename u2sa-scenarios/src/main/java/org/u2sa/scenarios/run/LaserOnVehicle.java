package org.u2sa.scenarios.run;

import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ray;
import org.u2sa.sim.world.World;

/**
 * How far a level laser on a vehicle sees in a direction, to the left positive [rad]: it tilts with
 * the vehicle.
 *
 * @param forwardM place ahead of the vehicle's reference point [m]
 * @param upM height above it [m]
 * @param rangeM beyond which it sees nothing [m]
 */
public record LaserOnVehicle(
    World world, Supplier<VehicleTruth> truth, double forwardM, double upM, double rangeM)
    implements DoubleUnaryOperator {
  @Override
  public double applyAsDouble(double angleRad) {
    VehicleTruth now = truth.get();
    Attitude attitude = now.attitude();
    Point ned = attitude.nedOf(Point.of(forwardM, 0.0, -upM));
    Point way = attitude.nedOf(Point.of(Math.cos(angleRad), Math.sin(angleRad), 0.0));
    Point from = now.position();
    Ray ray =
        new Ray(
            from.x() + ned.y(), from.y() + ned.x(), from.z() - ned.z(), way.y(), way.x(), -way.z());
    return world.distanceM(ray, rangeM);
  }
}
