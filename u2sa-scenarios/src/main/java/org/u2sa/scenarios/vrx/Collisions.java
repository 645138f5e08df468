package org.u2sa.scenarios.vrx;

import java.util.HashMap;
import java.util.Map;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * Counts contacts with objects of the world; a contact that persists or recurs within a second
 * counts once.
 */
final class Collisions {
  private static final double APART_S = 1.0;

  private final World solid;
  private final Footprint outline;
  private final Map<String, Double> touched = new HashMap<>(); // time of the last touch
  private int count;

  Collisions(VrxWorld world, Footprint outline) {
    solid = world.solid();
    this.outline = outline;
  }

  /**
   * Checks for contacts at a time in the running state.
   *
   * @param judge receives log lines
   * @return whether the boat touches anything
   */
  boolean see(VehicleTruth truth, double sinceS, VrxJudge judge) {
    Point flat = Point.of(truth.position().x(), truth.position().y(), 0.0);
    boolean touches = false;
    for (ObjectDescription each :
        solid.when(truth.timeS()).contacts(outline, flat, truth.headingRad())) {
      touches = true;
      Double before = touched.put(each.uid(), sinceS);
      if (before == null || sinceS - before > APART_S) {
        count++;
        judge.say(sinceS, "touches " + each.uid());
      }
    }
    return touches;
  }

  int count() {
    return count;
  }
}
