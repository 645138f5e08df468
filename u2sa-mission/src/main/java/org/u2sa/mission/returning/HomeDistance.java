package org.u2sa.mission.returning;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;

/** Finds missions whose home is so far from the vehicle that one of both places must be wrong. */
public final class HomeDistance {
  private static final double FAR_M = 100_000.0;

  private Waypoint checked; // newest home that was compared with a state; null at first

  /** Compares each home once, with the next position; empty unless it is far away. */
  public Optional<String> check(StateInformation state, Optional<Waypoint> home) {
    if (home.isEmpty()
        || home.get() == checked
        || !home.get().referenceFrame().isEarth()
        || !state.referenceFrame().isEarth()
        || state.x().isEmpty()
        || state.y().isEmpty()) {
      return Optional.empty();
    }
    checked = home.get();
    Geodetic here = onEarth(state);
    Geodetic there =
        onEarth(
            new StateInformation()
                .referenceFrame(checked.referenceFrame())
                .x(checked.x().orElseThrow())
                .y(checked.y().orElseThrow()));
    double metres = here.distanceM(there);
    return metres < FAR_M
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "the vehicle's state is at %s, %.0f km from the mission's home at %s: one of them must be wrong",
                words(here),
                metres / 1_000.0,
                words(there)));
  }

  private static Geodetic onEarth(StateInformation state) {
    StateInformation at = state.in(ReferenceFrame.GLOBAL);
    return new Geodetic(at.x().orElseThrow(), at.y().orElseThrow(), 0.0);
  }

  private static String words(Geodetic at) {
    return String.format(Locale.ROOT, "%.6f, %.6f deg", at.longitudeDeg(), at.latitudeDeg());
  }
}
