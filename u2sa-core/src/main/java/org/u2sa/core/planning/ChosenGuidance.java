package org.u2sa.core.planning;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.HandOver;

/**
 * The guidance that the configuration names at the moment; both know of each leg, so that it may
 * change on the way.
 */
final class ChosenGuidance implements WaypointGuidance {
  private final BooleanSupplier followsLines;
  private final WaypointGuidance lines;
  private final WaypointGuidance direct = new DirectGuidance();

  /**
   * @param followsLines false: heads straight for waypoints, as the thesis's planner did
   */
  ChosenGuidance(BooleanSupplier followsLines, Supplier<LineSettings> settings) {
    this.followsLines = followsLines;
    lines = new LineGuidance(settings);
  }

  private WaypointGuidance chosen() {
    return followsLines.getAsBoolean() ? lines : direct;
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

  @Override
  public boolean isApproaching() {
    return chosen().isApproaching();
  }

  @Override
  public void handOver(HandOver state) {
    lines.handOver(state);
  }

  @Override
  public void takeOver(HandOver state) {
    lines.takeOver(state);
  }
}
