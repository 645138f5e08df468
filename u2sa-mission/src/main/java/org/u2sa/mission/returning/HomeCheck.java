package org.u2sa.mission.returning;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;

/**
 * Finds missions whose home contradicts the vehicle's state: it is so far away that one of both
 * places must be wrong, or the vehicle begins beside it at another altitude.
 */
public final class HomeCheck {
  private static final double FAR_M = 100_000.0;
  private static final double BESIDE_M = 20.0;
  private static final double SLOW_MPS = 3.0; // may have taken off just now
  private static final double USEFUL_SIGMA_M = 10.0; // of an altitude
  private static final double START_S = 2.0;
  private static final double UNLIKE_M = 5.0; // of altitudes: homes are read off maps
  private static final double SIGMAS = 3.0;

  private Waypoint checked; // newest home whose distance was checked; null at first
  private Geodetic unlike; // newest home whose altitude was reported; null at first
  private long begunMicros = Long.MAX_VALUE; // time of the first useful altitude

  /** Compares each home once, with the next position; empty unless it is far away. */
  public Optional<String> distance(StateInformation state, Optional<Waypoint> home) {
    if (home.isEmpty() || home.get() == checked || !isComparable(state, home.get())) {
      return Optional.empty();
    }
    checked = home.get();
    Geodetic here = onEarth(state);
    Geodetic there = onEarth(place(checked));
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

  /**
   * Compares the altitude of the home with that of a slow vehicle beside it, in its first 2 s and
   * while it is known to be disarmed. Each home is reported once.
   *
   * @return empty unless they differ by more than 5 m and three sigmas
   */
  public Optional<String> altitude(
      StateInformation state, Optional<Geodetic> home, boolean isDisarmed) {
    long now = state.timestamp().orElse(0L);
    if (home.isEmpty()
        || home.get().equals(unlike)
        || !state.referenceFrame().equals(ReferenceFrame.GLOBAL)
        || state.x().isEmpty()
        || state.y().isEmpty()
        || state.z().isEmpty()
        || !(state.zSigma().orElse(Double.NaN) <= USEFUL_SIGMA_M)) {
      return Optional.empty();
    }
    begunMicros = Math.min(begunMicros, now);
    boolean mayStand = isDisarmed || now - begunMicros <= Clock.micros(START_S);
    double sigma = state.zSigma().getAsDouble();
    double z = state.z().getAsDouble();
    double apart = Math.abs(z - home.get().altitudeM());
    if (!mayStand
        || apart <= Math.max(UNLIKE_M, SIGMAS * sigma)
        || !isSlow(state)
        || onEarth(state).distanceM(onEarth(home.get())) > BESIDE_M) {
      return Optional.empty();
    }
    unlike = home.get();
    return Optional.of(
        String.format(
            Locale.ROOT,
            "the vehicle begins beside the mission's home, but at %.1f m (sigma %.1f m) instead of %.1f m above mean sea level: check home, receiver and QNH",
            z,
            sigma,
            unlike.altitudeM()));
  }

  private static boolean isComparable(StateInformation state, Waypoint home) {
    return home.referenceFrame().isEarth()
        && state.referenceFrame().isEarth()
        && state.x().isPresent()
        && state.y().isPresent();
  }

  private static boolean isSlow(StateInformation state) {
    return Stream.of(state.xDot(), state.yDot(), state.zDot())
        .mapToDouble((OptionalDouble each) -> Math.abs(each.orElse(0.0)))
        .allMatch(mps -> mps < SLOW_MPS);
  }

  private static StateInformation place(Waypoint home) {
    return new StateInformation()
        .referenceFrame(home.referenceFrame())
        .x(home.x().orElseThrow())
        .y(home.y().orElseThrow());
  }

  private static Geodetic onEarth(StateInformation state) {
    StateInformation at = state.in(ReferenceFrame.GLOBAL);
    return new Geodetic(at.x().orElseThrow(), at.y().orElseThrow(), 0.0);
  }

  private static Geodetic onEarth(Geodetic place) {
    return new Geodetic(place.longitudeDeg(), place.latitudeDeg(), 0.0);
  }

  private static String words(Geodetic at) {
    return String.format(Locale.ROOT, "%.6f, %.6f deg", at.longitudeDeg(), at.latitudeDeg());
  }
}
