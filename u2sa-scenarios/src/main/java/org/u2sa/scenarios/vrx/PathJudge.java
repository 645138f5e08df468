package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;

/**
 * Follow the path: 10 points per gate, 1 for consecutive gates, 1 for the last gate, −3 per
 * collision; higher is better. A gate is inert until the first is crossed, and void once crossed
 * the wrong way.
 */
final class PathJudge extends VrxJudge {
  private static final double GATE = 10.0;
  private static final double BONUS = 1.0;
  private static final double PENALTY = 3.0;
  private static final double BUFFER_S = 10.0; // between collisions that count

  /** Maximum score of a course, e.g. 99 for nine gates. */
  static long most(int gates) {
    return Math.round(gates * (GATE + BONUS));
  }

  private enum Place {
    OUTSIDE,
    BEFORE,
    AFTER,
    CROSSED,
    VOID
  }

  private final Collisions collisions;
  private final Place[] places;
  private int last = -1;
  private int lastGood = Integer.MIN_VALUE;
  private int crossed;
  private double collidedS = Double.NEGATIVE_INFINITY;
  private double score;

  PathJudge(VrxWorld world, Footprint outline, Path directory) {
    super(world, directory);
    collisions = new Collisions(world, outline);
    places = new Place[world.gates().size()];
    Arrays.fill(places, Place.OUTSIDE);
  }

  @Override
  void score(VehicleTruth truth, double sinceS) {
    collide(truth, sinceS);
    for (int i = last + 1; i < places.length; i++) {
      Place now = place(world().gates().get(i), truth.position());
      if (i != 0 && places[0] != Place.CROSSED) {
        break;
      }
      if (places[i] == Place.VOID || places[i] == Place.CROSSED) {
        continue;
      }
      if (now == Place.AFTER && places[i] == Place.BEFORE) {
        cross(i, sinceS);
        return;
      }
      if (i != 0 && now == Place.BEFORE && places[i] == Place.AFTER) {
        places[i] = Place.VOID;
        lastGood = Integer.MIN_VALUE;
        last = i;
        say(sinceS, "gate " + (i + 1) + " the wrong way");
        end(i);
        return;
      }
      places[i] = now;
    }
  }

  private void cross(int i, double sinceS) {
    places[i] = Place.CROSSED;
    score += GATE;
    crossed++;
    if (i != 0 && i == lastGood + 1) {
      score += BONUS;
    }
    last = i;
    lastGood = i;
    say(sinceS, "gate " + (i + 1));
    if (i == places.length - 1) {
      score += BONUS;
    }
    end(i);
  }

  private void end(int i) {
    if (i == places.length - 1) {
      finish();
    }
  }

  private static Place place(VrxWorld.Gate gate, Point at) {
    double heading = gate.headingRad();
    Point from = at.minus(gate.centre());
    double along = from.x() * Math.sin(heading) + from.y() * Math.cos(heading);
    double aside = from.x() * Math.cos(heading) - from.y() * Math.sin(heading);
    if (Math.abs(aside) > gate.widthM() / 2.0) {
      return Place.OUTSIDE;
    }
    return along >= 0.0 ? Place.AFTER : Place.BEFORE;
  }

  private void collide(VehicleTruth truth, double sinceS) {
    if (collisions.see(truth, sinceS, this) && sinceS - collidedS >= BUFFER_S) {
      collidedS = sinceS;
      score = Math.max(0.0, score - PENALTY);
    }
  }

  @Override
  double score() {
    return score;
  }

  @Override
  int contacts() {
    return collisions.count();
  }

  @Override
  Map<String, Double> figures() {
    return Map.of("gates", (double) crossed);
  }
}
