package org.u2sa.flightgear.link;

/**
 * Timing of a {@link StandInFlightGear}.
 *
 * @param rateHz lines per second of wall time [1/s, 1…1000]
 * @param speedUp simulated seconds per second of wall time [0.01…100]
 * @param loadingS wall time during which lines are sent before the flight model runs [s, at least
 *     0]
 * @param primerS simulated duration of the engine start [s, at least 0]; 0: the engine state is
 *     unchanged
 */
public record StandInSetup(double rateHz, double speedUp, double loadingS, double primerS) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public StandInSetup {
    require("rate [1/s]", rateHz, 1.0, 1_000.0);
    require("speed-up", speedUp, 0.01, 100.0);
    require("loading time [s]", loadingS, 0.0, 3_600.0);
    require("primer time [s]", primerS, 0.0, 3_600.0);
  }

  /** Timing of FlightGear 2020.3 with its c172p on a runway (docs/flightgear.md). */
  public static StandInSetup likeFlightGear() {
    return new StandInSetup(20.0, 1.0, 2.5, 7.5);
  }

  /** Lines start immediately, with the aircraft's current engine state. */
  public static StandInSetup ready(double rateHz, double speedUp) {
    return new StandInSetup(rateHz, speedUp, 0.0, 0.0);
  }

  private static void require(String name, double value, double lowest, double highest) {
    if (!(value >= lowest && value <= highest)) {
      throw new IllegalArgumentException(
          name + ": " + value + " is outside " + lowest + "…" + highest);
    }
  }
}
