package org.u2sa.sim.world;

import java.util.List;

/** A compound shape: several shapes that belong to one object. */
record Several(List<Obstacle> parts) implements Obstacle {
  @Override
  public Bounds bounds() {
    return parts.stream().map(Obstacle::bounds).reduce(Bounds.NONE, Bounds::and);
  }

  @Override
  public double distanceM(Ray ray) {
    return parts.stream().mapToDouble(part -> part.distanceM(ray)).min().orElse(NEVER);
  }

  @Override
  public boolean touches(Prism footprint) {
    return parts.stream().anyMatch(part -> part.touches(footprint));
  }
}
