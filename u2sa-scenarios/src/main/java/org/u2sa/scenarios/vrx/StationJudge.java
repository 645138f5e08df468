package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Station keeping: the mean pose error; lower is better. */
final class StationJudge extends VrxJudge {
  private static final double SETTLED_S = 60.0;

  private final PoseError error;
  private double sum;
  private double distances;
  private double turns;
  private double largestM; // once settled
  private int count;

  StationJudge(VrxWorld world, Path directory) {
    super(world, directory);
    error = new PoseError(world.goals().get(0), world.plane());
  }

  @Override
  void score(VehicleTruth truth, double sinceS) {
    double distance = error.distanceM(truth);
    if (count % 200 == 0) {
      say(
          sinceS,
          String.format(Locale.ROOT, "%.3f m, %.4f rad off", distance, error.turnRad(truth)));
    }
    sum += error.of(truth);
    distances += distance;
    turns += error.turnRad(truth);
    count++;
    if (sinceS > SETTLED_S) {
      largestM = Math.max(largestM, distance);
    }
  }

  @Override
  double score() {
    return count == 0 ? Double.NaN : sum / count;
  }

  @Override
  Map<String, Double> figures() {
    Map<String, Double> figures = new LinkedHashMap<>();
    figures.put("meanDistanceM", distances / Math.max(1, count));
    figures.put("meanHeadingErrorDeg", Math.toDegrees(turns / Math.max(1, count)));
    figures.put("maxDistanceAfterMinuteM", largestM);
    return figures;
  }
}
