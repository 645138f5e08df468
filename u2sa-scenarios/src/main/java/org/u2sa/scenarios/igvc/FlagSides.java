package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * On which side flags are passed: red ones belong to the right of the way, blue ones to its left. A
 * flag is passed where the vehicle was nearest to it, once it is farther away again.
 */
final class FlagSides {
  /**
   * Farther away a flag does not concern the vehicle: nobody passes it so between it and a line.
   */
  private static final double REACH_M = 2.5;

  private static final double PASSED_M = 0.1; // farther than at the nearest place
  private static final double MOVES_MPS = 0.1;

  private final List<Flag> flags = new ArrayList<>();

  private static final class Flag {
    final ObjectDescription object;
    final boolean isRed;
    double nearestM = REACH_M;
    boolean isWrong; // at the nearest place
    boolean isPassed; // until it is out of reach

    Flag(ObjectDescription object) {
      this.object = object;
      isRed = object.objectType().equals(Scenery.RED_FLAG);
    }

    /** Whether it has just been passed on the wrong side. */
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

  /** The flags that have just been passed on the wrong side. */
  List<ObjectDescription> wrong(VehicleTruth truth) {
    if (truth.speedMps() < MOVES_MPS) {
      return List.of(); // a vehicle that turns on the spot moves nowhere
    }
    return flags.stream()
        .filter(flag -> flag.see(truth.position(), truth.velocity()))
        .map(flag -> flag.object)
        .toList();
  }
}
