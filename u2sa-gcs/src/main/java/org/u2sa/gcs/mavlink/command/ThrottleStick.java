package org.u2sa.gcs.mavlink.command;

import java.util.OptionalInt;

/**
 * The axis z of MANUAL_CONTROL, −1000…1000 with rest at 0 or, as stations of PX4 send it, 0…1000
 * with rest at 500. The first message in the mode Manual shows where it rests.
 */
final class ThrottleStick {
  static final String NOT_AT_REST =
      "throttle ignored: it was not at rest, at 0 or 500, when the mode began";

  private static final int PX4_REST = 500;
  private static final int NEAR = 50;
  private static final double FULL = 1000.0;

  private OptionalInt rest = OptionalInt.empty();
  private boolean isSeen;

  /** Takes a value; true if it is the first value and not at rest; the axis is then ignored. */
  boolean see(int z) {
    if (isSeen) {
      return false;
    }
    isSeen = true;
    if (Math.abs(z) <= NEAR) {
      rest = OptionalInt.of(0);
    } else if (Math.abs(z - PX4_REST) <= NEAR) {
      rest = OptionalInt.of(PX4_REST);
    }
    return rest.isEmpty();
  }

  /** Share of full speed, forward positive; may exceed ±1. */
  double share(int z) {
    return rest.isEmpty() ? 0.0 : (z - rest.getAsInt()) / (FULL - rest.getAsInt());
  }
}
