package org.u2sa.scenarios.robosub.course;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Two upright hoops side by side, one of which is the target of two torpedoes.
 *
 * @param right middle of the right hoop
 * @param wrong middle of the other hoop
 * @param headingRad direction of their normals, clockwise from north
 * @param colours colours of the right and the other hoop
 * @param seed seed of the torpedoes' scatter
 */
record TorpedoTask(Point right, Point wrong, double headingRad, List<Colour> colours, long seed)
    implements CourseTask {
  private static final double RADIUS_M = 0.3;
  private static final double TUBE_M = 0.05;

  private ObjectDescription hoop(Colour colour, Point at) {
    Hoop hoop = new Hoop().colour(colour).radius(RADIUS_M).thickness(TUBE_M);
    hoop.psi(Math.PI / 2.0 - headingRad);
    return SubObjects.placed(hoop, SubObjects.type(colour, "hoop"), at);
  }

  @Override
  public List<ObjectDescription> objects() {
    return List.of(hoop(colours.get(0), right), hoop(colours.get(1), wrong));
  }

  @Override
  public List<Goal> goals() {
    return List.of(
        new Goal("shootTorpedoes", "torpedo", List.of(SubObjects.type(colours.get(0), "hoop"))));
  }

  @Override
  public SubTaskJudge judge() {
    return new Judge();
  }

  private final class Judge implements SubTaskJudge {
    private final Projectiles projectiles = new Projectiles(seed);
    private int shot;
    private int through;

    @Override
    public Optional<String> released(String actuator, VehicleTruth truth) {
      if (!actuator.equals("LAUNCHER")) {
        return Optional.empty();
      }
      Point normal = Point.of(Math.cos(headingRad), Math.sin(headingRad), 0.0);
      Optional<Double> missM = projectiles.missM(truth, right, normal);
      shot++;
      boolean isThrough = missM.isPresent() && missM.get() < RADIUS_M - TUBE_M / 2.0;
      through += isThrough && shot <= SubJudge.CARRIED ? 1 : 0;
      return Optional.of(
          missM
              .map(miss -> String.format(Locale.ROOT, "torpedo %.2f m off the hoop's middle", miss))
              .orElse("torpedo does not reach the hoop"));
    }

    @Override
    public Optional<String> violation() {
      return through == SubJudge.CARRIED
          ? Optional.empty()
          : Optional.of(
              String.format("torpedo: %d of %d through the hoop", through, SubJudge.CARRIED));
    }

    @Override
    public Map<String, Integer> counts() {
      return Map.of("torpedoesThroughHoop", through);
    }
  }
}
