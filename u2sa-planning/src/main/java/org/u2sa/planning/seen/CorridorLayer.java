package org.u2sa.planning.seen;

import java.util.List;
import org.u2sa.planning.search.GridFrame;

/** The planner's cells outside all corridors. Immutable. */
final class CorridorLayer {
  private final List<PlanarShape> corridors;
  private final GridFrame frame;
  private final boolean[] isOutside;

  private CorridorLayer(List<PlanarShape> corridors, GridFrame frame) {
    this.corridors = corridors;
    this.frame = frame;
    isOutside = new boolean[frame.cells()];
    for (int i = 0; i < isOutside.length; i++) {
      double north = frame.centreNorthM(i);
      double east = frame.centreEastM(i);
      boolean inside = false;
      for (PlanarShape corridor : corridors) {
        inside |= corridor.distanceM(north, east) == 0.0;
      }
      isOutside[i] = !inside;
    }
  }

  /**
   * Draws corridors.
   *
   * @param before previous layer, which is returned if nothing has changed; null for none
   */
  static CorridorLayer of(List<PlanarShape> corridors, GridFrame frame, CorridorLayer before) {
    return before != null && before.frame.equals(frame) && before.isOf(corridors)
        ? before
        : new CorridorLayer(corridors, frame);
  }

  private boolean isOf(List<PlanarShape> others) {
    boolean same = corridors.size() == others.size();
    for (int i = 0; same && i < others.size(); i++) {
      same = corridors.get(i).isOfSameOutline(others.get(i));
    }
    return same;
  }

  boolean isOutside(int cell) {
    return isOutside[cell];
  }
}
