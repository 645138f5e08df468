package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Checks on which side flags are passed: red flags must be to the right of the path and blue flags
 * to its left. The side is taken at the closest approach, once the vehicle moves away again.
 */
final class FlagSides {
  /** Distance beyond which flags are ignored: too far to pass between the flag and a line. */
  private static final double REACH_M = 2.5;

  private static final double PASSED_M = 0.1; // beyond the closest approach
  private static final double MOVES_MPS = 0.1;

  private final List<Flag> flags = new ArrayList<>();

  private static final class Flag {
    final ObjectDescription object;
    final boolean isRed;
    double nearestM = REACH_M;
    boolean isWrong; // side at the closest approach
    boolean isPassed; // until it is out of reach

    Flag(ObjectDescription object) {
      this.object = object;
      isRed = object.objectType().equals(Scenery.RED_FLAG);
    }

    /** Whether the flag was just passed on the wrong side. */
    boolean see(Point at, Point velocity) {
      double east = object.x() - at.x();
      double north = object.y() - at.y();
      double away = StrictMath.sqrt(east * east + north * north);
      if (away > REACH_M) {
        nearestM = REACH_M;
        isPassed = false;
      } else if (away < nearestM) {
        nearestM = away;
        boolean isRight = east * velocity.y() - north * velocity.x() > 0.0;
        isWrong = isRight != isRed;
      } else if (!isPassed && away > nearestM + PASSED_M) {
        isPassed = true;
        return isWrong;
      }
      return false;
    }
  }

  FlagSides(Course course) {
    course.of(Scenery.RED_FLAG).forEach(object -> flags.add(new Flag(object)));
    course.of(Scenery.BLUE_FLAG).forEach(object -> flags.add(new Flag(object)));
  }

  /** Flags that were just passed on the wrong side. */
  List<ObjectDescription> wrong(VehicleTruth truth) {
    if (truth.speedMps() < MOVES_MPS) {
      return List.of(); // turning in place has no direction of travel
    }
    return flags.stream()
        .filter(flag -> flag.see(truth.position(), truth.velocity()))
        .map(flag -> flag.object)
        .toList();
  }
}
