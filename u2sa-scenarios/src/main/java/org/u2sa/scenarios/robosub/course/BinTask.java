package org.u2sa.scenarios.robosub.course;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Bin;
import org.u2sa.messages.marine.Colour;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Two bins on the floor; two markers are dropped into one of them.
 *
 * @param right middle of the right bin
 * @param wrong middle of the other bin
 * @param colours colours of the right and the other bin
 * @param seed seed of the markers' scatter
 */
record BinTask(Point right, Point wrong, List<Colour> colours, long seed) implements CourseTask {
  private static final double INSIDE_M = 0.3; // from the middle

  private ObjectDescription bin(Colour colour, Point at) {
    Bin bin = new Bin().colour(colour).length(2.0 * INSIDE_M).width(2.0 * INSIDE_M).height(0.2);
    return SubObjects.placed(bin, SubObjects.type(colour, "bin"), at);
  }

  @Override
  public List<ObjectDescription> objects() {
    return List.of(bin(colours.get(0), right), bin(colours.get(1), wrong));
  }

  @Override
  public List<Goal> goals() {
    return List.of(new Goal("dropMarkers", "bin", List.of(SubObjects.type(colours.get(0), "bin"))));
  }

  @Override
  public SubTaskJudge judge() {
    return new Judge();
  }

  private final class Judge implements SubTaskJudge {
    private final Projectiles projectiles = new Projectiles(seed);
    private int dropped;
    private int inside;

    @Override
    public Optional<String> released(String actuator, VehicleTruth truth) {
      if (!actuator.equals("DROPPER")) {
        return Optional.empty();
      }
      double offM = projectiles.landing(truth, right.z()).distanceTo(right);
      dropped++;
      inside += offM < INSIDE_M && dropped <= SubJudge.CARRIED ? 1 : 0;
      return Optional.of(
          String.format(Locale.ROOT, "marker lands %.2f m from the bin's middle", offM));
    }

    @Override
    public Optional<String> violation() {
      return inside == SubJudge.CARRIED
          ? Optional.empty()
          : Optional.of(String.format("bin: %d of %d markers inside", inside, SubJudge.CARRIED));
    }

    @Override
    public Map<String, Integer> counts() {
      return Map.of("markersInBin", inside);
    }
  }
}
