package org.u2sa.sim.marine;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/**
 * An actuator of a hull with a first-order lag, in forward, right, down axes. The lag applies to
 * its level: a thrust, a speed or an angle.
 */
public sealed interface VesselActuator permits VesselThruster, MarinePropeller, Fin {
  /** Name used in commands. */
  String name();

  /** Time constant of the lag [s]. */
  double timeConstantS();

  /** Steady-state level at a command −1…1. */
  double level(double command);

  /** Electrical power at a level [W]; empty if unknown. */
  OptionalDouble powerW(double level);

  /**
   * Adds its force and moment at a level.
   *
   * @param u velocity through the water, forward [m/s]
   * @param v right [m/s]
   * @param w down [m/s]
   * @param force forward, right, down [N]; roll, pitch, yaw [N m]
   */
  void act(double level, double u, double v, double w, double[] force);

  /** Adds a force along a direction, and its moment about the reference point. */
  static void push(double newtons, Point direction, Point at, double[] force) {
    force[0] += newtons * direction.x();
    force[1] += newtons * direction.y();
    force[2] += newtons * direction.z();
    force[3] += newtons * (at.y() * direction.z() - at.z() * direction.y());
    force[4] += newtons * (at.z() * direction.x() - at.x() * direction.z());
    force[5] += newtons * (at.x() * direction.y() - at.y() * direction.x());
  }
}
