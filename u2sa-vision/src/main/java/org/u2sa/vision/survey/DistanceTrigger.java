package org.u2sa.vision.survey;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** Triggers a camera at the start and each time a horizontal distance has been travelled. */
final class DistanceTrigger {
  private OptionalDouble distanceM = OptionalDouble.empty();
  private Optional<Geodetic> last = Optional.empty(); // position at the last trigger
  private double flownM;

  /** Sets the distance [m]; empty: no images. A new distance triggers immediately. */
  void each(OptionalDouble metres) {
    if (!metres.equals(distanceM)) {
      distanceM = metres;
      last = Optional.empty();
    }
  }

  boolean isOn() {
    return distanceM.isPresent();
  }

  /**
   * Whether an image is due at this state; if so, restarts the distance.
   *
   * @param state in GLOBAL
   */
  boolean isDue(StateInformation state) {
    Geodetic here = new Geodetic(state.x().orElseThrow(), state.y().orElseThrow(), 0.0);
    if (distanceM.isEmpty()) {
      return false;
    }
    boolean isFirst = last.isEmpty();
    Point way = last.orElse(here).nedOf(here);
    flownM = isFirst ? 0.0 : flownM + Math.hypot(way.x(), way.y());
    last = Optional.of(here);
    if (!isFirst && flownM < distanceM.getAsDouble()) {
      return false;
    }
    flownM = isFirst ? 0.0 : flownM % distanceM.getAsDouble();
    return true;
  }
}
