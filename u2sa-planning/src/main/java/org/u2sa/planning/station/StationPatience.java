package org.u2sa.planning.station;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.Station;

/** Limits the time spent near a station that cannot be kept for its duration. */
public final class StationPatience {
  private double nearS; // time since the vehicle first came near
  private long beforeMicros = Long.MIN_VALUE; // of the previous state

  /**
   * Begins or continues a goal.
   *
   * @param soFarS time already spent near the station [s]
   */
  public void begin(double soFarS) {
    nearS = soFarS;
    beforeMicros = Long.MIN_VALUE;
  }

  /** Time since the vehicle first came near [s]. */
  public double nearS() {
    return nearS;
  }

  /** Counts the {@linkplain org.u2sa.planning.goals.PursuitTime time} since the previous state. */
  public void count(boolean isNear, long pursuedMicros) {
    if ((isNear || nearS > 0.0) && beforeMicros != Long.MIN_VALUE) {
      nearS += Clock.seconds(pursuedMicros - beforeMicros);
    }
    beforeMicros = pursuedMicros;
  }

  /** Why the station is given up; empty if it is not. One without a duration never is. */
  public Optional<String> end(Station station, StationVariables settings) {
    if (station.duration().isEmpty() || settings.stationGiveUpAfter() <= 0.0) {
      return Optional.empty();
    }
    double wayS = station.approach().orElse(0.0) / station.speed().orElse(settings.berthSpeed());
    double limitS = station.duration().getAsDouble() + wayS + settings.stationGiveUpAfter();
    return nearS < limitS
        ? Optional.empty()
        : Optional.of(
            String.format(Locale.ROOT, "given up: not kept for its duration within %.0f s", nearS));
  }
}
