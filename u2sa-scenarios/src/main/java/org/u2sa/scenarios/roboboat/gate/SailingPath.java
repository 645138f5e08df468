package org.u2sa.scenarios.roboboat.gate;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Pose;

/** A way over the water as closely spaced poses, sailed in order. Not thread-safe. */
public final class SailingPath {
  /** Maximum distance between two poses [m]. */
  static final double SPACING_M = 0.25;

  private static final int WINDOW = 12; // number of poses ahead searched for the nearest one

  private final List<Pose> poses;
  private int at; // pose nearest to the boat

  public SailingPath(List<Pose> poses) {
    this.poses = List.copyOf(poses);
  }

  /** Follows the boat along the path. */
  public void follow(Point here) {
    int nearest = at;
    for (int i = at; i < Math.min(poses.size(), at + WINDOW); i++) {
      if (awayM(i, here) < awayM(nearest, here)) {
        nearest = i;
      }
    }
    at = nearest;
  }

  private double awayM(int pose, Point here) {
    return poses.get(pose).distanceM(here.x(), here.y());
  }

  /** Distance of the boat from the path [m]. */
  public double offM(Point here) {
    return awayM(at, here);
  }

  /** Upper bound of the remaining length [m]. */
  public double leftM() {
    return (poses.size() - 1 - at) * SPACING_M;
  }

  /** Point at this distance along the path; straight on beyond its end. */
  public Point ahead(double metres) {
    int steps = (int) Math.ceil(metres / SPACING_M);
    int index = Math.min(poses.size() - 1, at + steps);
    Pose pose = poses.get(index).along(Math.max(0.0, metres - leftM()), 0.0);
    return Point.of(pose.northM(), pose.eastM(), 0.0);
  }
}
