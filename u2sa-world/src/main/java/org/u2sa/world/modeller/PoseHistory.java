package org.u2sa.world.modeller;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Recent vehicle states, with interpolation between them. */
public final class PoseHistory {
  private static final long SPAN_MICROS = 5 * Clock.MICROS_PER_SECOND;
  private static final double TURN_DEG = 360.0;
  private static final StateField[] PLACE = {StateField.X, StateField.Y, StateField.Z};
  private static final StateField[] ANGLES = {StateField.PHI, StateField.THETA, StateField.PSI};

  private final TreeMap<Long, StateInformation> states = new TreeMap<>();

  /** Adds a state; returns false if it lacks x, y, psi or a timestamp, or is in a body frame. */
  public boolean add(StateInformation state) {
    if (state.x().isEmpty()
        || state.y().isEmpty()
        || state.psi().isEmpty()
        || state.timestamp().isEmpty()
        || state.referenceFrame().isBody()) {
      return false;
    }
    long time = state.timestamp().getAsLong();
    boolean other =
        !states.isEmpty()
            && (!states.lastEntry().getValue().referenceFrame().equals(state.referenceFrame())
                || time < states.lastKey() - SPAN_MICROS); // the clock was set back
    if (other) {
      states.clear();
    }
    states.put(time, state);
    long oldest = states.lastKey() - SPAN_MICROS;
    while (states.firstKey() < oldest) {
      states.pollFirstEntry();
    }
    return true;
  }

  public Optional<StateInformation> newest() {
    return states.isEmpty() ? Optional.empty() : Optional.of(states.lastEntry().getValue());
  }

  /** Time of the newest state [µs]; {@link Long#MIN_VALUE} before the first. */
  public long newestMicros() {
    return states.isEmpty() ? Long.MIN_VALUE : states.lastKey();
  }

  /**
   * State at a time: interpolated, or extrapolated from the newest by its velocity and turn rate.
   *
   * @param gapMicros maximum gap between two states, and maximum extrapolation [µs]
   * @return empty if no states are close enough
   */
  public Optional<StateInformation> at(long micros, long gapMicros) {
    Map.Entry<Long, StateInformation> before = states.floorEntry(micros);
    if (before == null) {
      return Optional.empty();
    }
    if (before.getKey() == micros) {
      return Optional.of(before.getValue());
    }
    Map.Entry<Long, StateInformation> after = states.higherEntry(micros);
    if (after == null) {
      return micros - before.getKey() <= gapMicros
          ? Optional.of(ahead(before.getValue(), Clock.seconds(micros - before.getKey())))
          : Optional.empty();
    }
    long gap = after.getKey() - before.getKey();
    return gap <= gapMicros
        ? Optional.of(
            between(before.getValue(), after.getValue(), (micros - before.getKey()) / (double) gap))
        : Optional.empty();
  }

  /** Interpolates between two states of one frame; fields that only the first has are copied. */
  static StateInformation between(StateInformation a, StateInformation b, double share) {
    StateInformation state = a.copy();
    for (StateField field : PLACE) {
      if (a.number(field).isPresent() && b.number(field).isPresent()) {
        double from = a.number(field).getAsDouble();
        state.number(field, from + share * (b.number(field).getAsDouble() - from));
      }
    }
    if (a.referenceFrame().equals(ReferenceFrame.GLOBAL)
        && a.x().isPresent()
        && b.x().isPresent()) {
      double way = Math.IEEEremainder(b.x().getAsDouble() - a.x().getAsDouble(), TURN_DEG);
      state.x(Math.IEEEremainder(a.x().getAsDouble() + share * way, TURN_DEG));
    }
    for (StateField field : ANGLES) {
      if (a.number(field).isPresent() && b.number(field).isPresent()) {
        double from = a.number(field).getAsDouble();
        double way = Math.IEEEremainder(b.number(field).getAsDouble() - from, 2.0 * Math.PI);
        state.number(field, from + share * way);
      }
    }
    return state;
  }

  private static StateInformation ahead(StateInformation from, double seconds) {
    StateInformation state = from.copy();
    double x = seconds * from.xDot().orElse(0.0);
    double y = seconds * from.yDot().orElse(0.0);
    double z = seconds * from.zDot().orElse(0.0);
    if (from.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      double altitude = from.z().orElse(0.0);
      Point moved =
          new Geodetic(from.x().orElseThrow(), from.y().orElseThrow(), altitude)
              .fromEnu(Point.of(x, y, z))
              .point();
      state.x(moved.x()).y(moved.y());
    } else {
      state.x(from.x().orElseThrow() + x).y(from.y().orElseThrow() + y);
    }
    from.z().ifPresent(height -> state.z(height + z));
    from.psiDot().ifPresent(rate -> state.psi(from.psi().orElseThrow() + seconds * rate));
    from.phiDot().ifPresent(rate -> state.phi(from.phi().orElse(0.0) + seconds * rate));
    from.thetaDot().ifPresent(rate -> state.theta(from.theta().orElse(0.0) + seconds * rate));
    return state;
  }
}
