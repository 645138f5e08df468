package org.u2sa.core.safety;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Geodetic;

/** Corners of the fence in force, without FENCE MARGIN; another object after each change. */
public final class FenceOutline {
  private final Optional<Fence> fence; // empty if no fence is in force

  FenceOutline(Optional<Fence> fence) {
    this.fence = fence;
  }

  /**
   * Corners of the keep-in area; empty if there is none.
   *
   * @param local origin of local frames
   */
  public List<Geodetic> keepIn(Geodetic local) {
    return fence.map(each -> each.corners(local)).orElse(List.of());
  }

  /** Corners of each keep-out area; as {@link #keepIn}. */
  public List<List<Geodetic>> keepOuts(Geodetic local) {
    return fence.map(each -> each.keepOutCorners(local)).orElse(List.of());
  }
}
