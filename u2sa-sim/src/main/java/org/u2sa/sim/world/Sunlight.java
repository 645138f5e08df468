package org.u2sa.sim.world;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * The sun for greyscale cameras: shadows, shading of slopes, and its disc in the sky.
 *
 * @param azimuthRad clockwise from north [rad]
 * @param elevationRad above the horizon, 0.02…π/2 [rad]
 * @param brightness of the scene, 0 night … 1 the camera's exposure … 10
 * @param share of the light on level ground that is direct, 0 overcast … 1
 */
public record Sunlight(double azimuthRad, double elevationRad, double brightness, double share) {
  private static final double DISC_RAD = 0.03; // including its bloom
  private static final double OFF_GROUND_M = 1e-3;

  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public Sunlight {
    Arguments.requireFinite("azimuth of the sun [rad]", azimuthRad);
    Arguments.requireInside("elevation of the sun [rad]", elevationRad, 0.02, Math.PI / 2.0);
    Arguments.requireInside("brightness", brightness, 0.0, 10.0);
    Arguments.requireInside("share of direct light", share, 0.0, 1.0);
  }

  /** Unit vector to the sun: east, north, up. */
  private Point direction() {
    double level = StrictMath.cos(elevationRad);
    return Point.of(
        level * StrictMath.sin(azimuthRad),
        level * StrictMath.cos(azimuthRad),
        StrictMath.sin(elevationRad));
  }

  /**
   * Brightness in this light, 0…1.
   *
   * @param even brightness in even light
   * @param rangeM maximum length of shadows [m]
   */
  public double lit(double even, Ray view, Optional<World.Hit> hit, World world, double rangeM) {
    Point sun = direction();
    if (hit.isEmpty()) {
      double cosine = view.dx() * sun.x() + view.dy() * sun.y() + view.dz() * sun.z();
      boolean isSun = share > 0.0 && brightness > 0.0 && cosine > StrictMath.cos(DISC_RAD);
      return isSun ? 1.0 : Math.min(1.0, even * brightness);
    }
    double direct = 1.0;
    if (hit.get().object().isEmpty()) {
      Point at = hit.get().at();
      double east = world.terrain().riseEast(at.x(), at.y());
      double north = world.terrain().riseNorth(at.x(), at.y());
      double facing = sun.z() - east * sun.x() - north * sun.y();
      double length = StrictMath.sqrt(1.0 + east * east + north * north);
      Ray toSun = new Ray(at.x(), at.y(), at.z() + OFF_GROUND_M, sun.x(), sun.y(), sun.z());
      boolean isShaded = Double.isFinite(world.distanceM(toSun, rangeM));
      direct = isShaded ? 0.0 : Math.max(0.0, facing / length / sun.z());
    }
    return Math.min(1.0, even * brightness * (1.0 - share + share * direct));
  }
}
