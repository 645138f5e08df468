package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Wayfinding: the mean of the waypoints' smallest pose errors; lower is better. */
final class WayfindingJudge extends VrxJudge {
  private static final double NEAR = 0.1; // logged when first below

  private final List<PoseError> errors;
  private final double[] least;

  WayfindingJudge(VrxWorld world, Path directory) {
    super(world, directory);
    errors = world.goals().stream().map(goal -> new PoseError(goal, world.plane())).toList();
    least = new double[errors.size()];
    Arrays.fill(least, Double.POSITIVE_INFINITY);
  }

  @Override
  void score(VehicleTruth truth, double sinceS) {
    for (int i = 0; i < least.length; i++) {
      double error = errors.get(i).of(truth);
      if (least[i] > NEAR && error <= NEAR) {
        say(sinceS, "waypoint " + (i + 1) + " within 0.1");
      }
      least[i] = Math.min(least[i], error);
    }
  }

  @Override
  double score() {
    return Arrays.stream(least).average().orElse(Double.NaN);
  }

  @Override
  Map<String, Double> figures() {
    Map<String, Double> figures = new LinkedHashMap<>();
    for (int i = 0; i < least.length; i++) {
      figures.put(String.format(Locale.ROOT, "waypoint%d", i + 1), least[i]);
    }
    return figures;
  }
}
