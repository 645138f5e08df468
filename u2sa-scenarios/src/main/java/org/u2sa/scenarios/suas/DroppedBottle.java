package org.u2sa.scenarios.suas;

import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Computes where the bottle lands from its true position and velocity, in the field's steady wind:
 * a = g − g |v| v / v∞², v through the air. Shares no code with the planner's forecast.
 */
final class DroppedBottle {
  /** Speed at which drag equals weight [m/s]. */
  static final double TERMINAL_MPS = 25.0;

  private static final double STEP_S = 0.001;

  private DroppedBottle() {}

  /** Point of impact: east, north [m]. */
  static Point landing(SuasField field, VehicleTruth release) {
    double windEast = -field.windMps() * Math.sin(field.windFromRad());
    double windNorth = -field.windMps() * Math.cos(field.windFromRad());
    Point at = release.position();
    Point v = release.velocity();
    double drag = Gravity.STANDARD_MPS2 / (TERMINAL_MPS * TERMINAL_MPS);
    while (at.z() > 0.0) {
      Point air = v.minus(Point.of(windEast, windNorth, 0.0));
      Point pull = Point.of(0.0, 0.0, -Gravity.STANDARD_MPS2);
      v = v.plus(pull.minus(air.times(drag * air.distance())).times(STEP_S));
      at = at.plus(v.times(STEP_S));
    }
    return at;
  }
}
