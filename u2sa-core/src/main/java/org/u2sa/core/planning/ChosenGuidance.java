package org.u2sa.core.planning;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.messages.frame.Point;

/**
 * The guidance that the configuration names at the moment; both know of each leg, so that it may
 * change on the way.
 */
final class ChosenGuidance implements WaypointGuidance {
  private final Supplier<PlanningSettings> settings;
  private final WaypointGuidance lines;
  private final WaypointGuidance direct = new DirectGuidance();

  ChosenGuidance(Supplier<PlanningSettings> settings) {
    this.settings = settings;
    lines = new LineGuidance(() -> settings.get().lines());
  }

  private WaypointGuidance chosen() {
    return settings.get().followsLines() ? lines : direct;
  }

  @Override
  public void begin(Optional<Place> start) {
    lines.begin(start);
    direct.begin(start);
  }

  @Override
  public Point towards(Vehicle vehicle, Place target, double threshold, Optional<Place> after) {
    return chosen().towards(vehicle, target, threshold, after);
  }

  @Override
  public Point bodyPoint(Vehicle vehicle, Point ned) {
    return chosen().bodyPoint(vehicle, ned);
  }

  @Override
  public boolean hasPassed() {
    return chosen().hasPassed();
  }

  @Override
  public boolean isNearest() {
    return chosen().isNearest();
  }
}
