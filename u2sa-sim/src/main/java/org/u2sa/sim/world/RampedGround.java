package org.u2sa.sim.world;

import java.util.List;
import java.util.function.ToDoubleFunction;

/** Terrain and surface of a level lawn with non-overlapping board ramps. */
public final class RampedGround implements Terrain, Surface {
  private final List<Ramp> ramps;
  private final Surface lawn = Surface.lawn();
  private final Surface boards = Surface.concrete();

  /** Creates level ground with these ramps. */
  public RampedGround(List<Ramp> ramps) {
    this.ramps = List.copyOf(ramps);
  }

  @Override
  public double heightM(double eastM, double northM) {
    double height = 0.0;
    for (Ramp ramp : ramps) {
      height = Math.max(height, ramp.heightM(eastM, northM));
    }
    return height;
  }

  @Override
  public double riseEast(double eastM, double northM) {
    return sum(ramp -> ramp.riseEast(eastM, northM));
  }

  @Override
  public double riseNorth(double eastM, double northM) {
    return sum(ramp -> ramp.riseNorth(eastM, northM));
  }

  private double sum(ToDoubleFunction<Ramp> rise) {
    double sum = 0.0;
    for (Ramp ramp : ramps) {
      sum += rise.applyAsDouble(ramp);
    }
    return sum;
  }

  /** Maximum slope of the ramps' ascents and descents; the vertical sides are excluded. */
  @Override
  public double steepest() {
    return ramps.stream().mapToDouble(Ramp::steepest).max().orElse(0.0);
  }

  @Override
  public double highestM() {
    return ramps.stream().mapToDouble(Ramp::highestM).max().orElse(0.0);
  }

  @Override
  public double distanceM(Ray ray, double rangeM) {
    double nearest = Terrain.flat().distanceM(ray, rangeM);
    for (Ramp ramp : ramps) {
      nearest =
          Math.min(
              nearest, ramp.meets(ray.x(), ray.y(), ray.z(), ray.dx(), ray.dy(), ray.dz(), null));
    }
    return nearest <= rangeM ? nearest : Double.POSITIVE_INFINITY;
  }

  /** The lawn's value everywhere, because boards become wet and dirty. */
  @Override
  public double grip(double eastM, double northM) {
    return lawn.grip(eastM, northM);
  }

  /** Boards roll like concrete. */
  @Override
  public double rollingResistance(double eastM, double northM) {
    boolean isOnBoards = ramps.stream().anyMatch(ramp -> ramp.carries(eastM, northM));
    return (isOnBoards ? boards : lawn).rollingResistance(eastM, northM);
  }
}
