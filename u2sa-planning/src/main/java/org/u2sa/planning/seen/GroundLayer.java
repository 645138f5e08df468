package org.u2sa.planning.seen;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.u2sa.planning.search.GridFrame;

/** The planner's cells in which the ground is too high to fly over. Immutable. */
final class GroundLayer {
  static final double ROUNDING_M = 0.01; // of heights on ground as high as the goal's

  private final FlightProfile profile;
  private final GridFrame frame;
  private final float[] downs; // of the ground, by cell [m]; NaN: unknown
  private final boolean[] isHigh;
  private final List<PlanarShape> shapes;

  private GroundLayer(FlightProfile profile, GridFrame frame, float[] downs) {
    this.profile = profile;
    this.frame = frame;
    this.downs = downs;
    isHigh = new boolean[frame.cells()];
    for (int i = 0; i < isHigh.length; i++) {
      isHigh[i] =
          profile.isTooHigh(frame.centreNorthM(i), frame.centreEastM(i), downs[i] + ROUNDING_M);
    }
    shapes = GroundOutlines.of(isHigh, frame);
  }

  /**
   * Determines the cells.
   *
   * @param ground down coordinate of the ground at north and east [m]; NaN if unknown
   * @param before previous layer of the same ground, which is returned if nothing has changed; null
   *     for none
   */
  static GroundLayer of(
      FlightProfile profile, DoubleBinaryOperator ground, GridFrame frame, GroundLayer before) {
    if (before == null || !before.frame.equals(frame)) {
      return new GroundLayer(profile, frame, downs(ground, frame));
    }
    return before.profile.equals(profile) ? before : new GroundLayer(profile, frame, before.downs);
  }

  private static float[] downs(DoubleBinaryOperator ground, GridFrame frame) {
    float[] downs = new float[frame.cells()];
    for (int i = 0; i < downs.length; i++) {
      downs[i] = (float) ground.applyAsDouble(frame.centreNorthM(i), frame.centreEastM(i));
    }
    return downs;
  }

  boolean isHigh(int cell) {
    return isHigh[cell];
  }

  /**
   * Outlines of the largest coherent areas of such cells, without dents; empty if there are none.
   */
  List<PlanarShape> shapes() {
    return shapes;
  }
}
