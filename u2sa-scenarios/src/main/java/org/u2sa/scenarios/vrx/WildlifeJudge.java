package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;

/**
 * Wildlife: the time until all circles are completed, up to that of the running state, less a bonus
 * for each circle and each animal successfully avoided; lower is better.
 *
 * <p>A circle consists of eight gates from the animal outwards, crossed in the right direction
 * without leaving the engagement distance; a gate crossed the other way, and a collision, restart
 * it (WildlifeScoringPlugin.cc).
 */
final class WildlifeJudge extends VrxJudge {
  private static final int GATES = 8;

  private final Collisions collisions;
  private final List<Circle> circles = new ArrayList<>();
  private double elapsedS;

  private enum Side {
    OUTSIDE,
    BEFORE,
    AFTER,
    CROSSED
  }

  /** Progress with one animal. */
  private final class Circle {
    private final Wildlife.Animal animal;
    private final Side[] gates = new Side[GATES];
    private boolean engaged;
    private boolean everEngaged;
    private boolean isDone;
    private int crossed;

    Circle(Wildlife.Animal animal) {
      this.animal = animal;
      Arrays.fill(gates, Side.OUTSIDE);
    }

    void see(VehicleTruth truth, double sinceS) {
      Point way = truth.position().minus(animal.mover().at(truth.timeS()).position());
      boolean isNear = Math.hypot(way.x(), way.y()) <= world().wildlife().engagementM();
      if (isDone) {
        return;
      }
      if (isNear != engaged) {
        engaged = isNear;
        everEngaged = true;
        crossed = isNear ? crossed : 0;
        say(sinceS, (isNear ? "engages " : "leaves ") + animal.name());
      } else if (engaged && animal.part() != Wildlife.Part.AVOID) {
        cross(way, sinceS);
      }
    }

    private void cross(Point way, double sinceS) {
      boolean isClockwise = animal.part() == Wildlife.Part.CLOCKWISE;
      for (int i = 0; i < GATES; i++) {
        Side now = side(way, 2.0 * Math.PI * i / GATES);
        boolean anticlockwise = now == Side.AFTER && gates[i] == Side.BEFORE;
        boolean clockwise = now == Side.BEFORE && gates[i] == Side.AFTER;
        if (anticlockwise || clockwise) {
          now = Side.CROSSED;
          crossed = clockwise == isClockwise ? crossed + 1 : 0;
          if (crossed == GATES) {
            isDone = true;
            say(sinceS, animal.name() + " circled");
          }
        }
        gates[i] = now;
      }
    }

    /**
     * One gate around an animal, at an angle anticlockwise from east, as wide as the engagement
     * distance.
     */
    private Side side(Point way, double angle) {
      double out = way.x() * Math.cos(angle) + way.y() * Math.sin(angle);
      double on = way.y() * Math.cos(angle) - way.x() * Math.sin(angle);
      double width = world().wildlife().engagementM();
      return out < 0.0 || out > width ? Side.OUTSIDE : on >= 0.0 ? Side.AFTER : Side.BEFORE;
    }

    boolean isReached() {
      return animal.part() == Wildlife.Part.AVOID ? !everEngaged : isDone;
    }
  }

  WildlifeJudge(VrxWorld world, Footprint outline, Path directory) {
    super(world, directory);
    collisions = new Collisions(world, outline);
    world.wildlife().animals().forEach(each -> circles.add(new Circle(each)));
  }

  @Override
  void score(VehicleTruth truth, double sinceS) {
    elapsedS = sinceS;
    boolean collides = collisions.see(truth, sinceS, this);
    for (Circle each : circles) {
      each.crossed = collides ? 0 : each.crossed;
      each.see(truth, sinceS);
    }
    if (circles.stream()
        .allMatch(each -> each.isDone || each.animal.part() == Wildlife.Part.AVOID)) {
      finish();
    }
  }

  @Override
  double score() {
    long reached = circles.stream().filter(Circle::isReached).count();
    return Math.min(elapsedS, world().times().runningS()) - reached * world().wildlife().bonusS();
  }

  @Override
  int contacts() {
    return collisions.count();
  }

  @Override
  Map<String, Double> figures() {
    return Map.of(
        "seconds",
        elapsedS,
        "animals",
        (double) circles.size(),
        "animalsDealtWith",
        (double) circles.stream().filter(Circle::isReached).count());
  }
}
