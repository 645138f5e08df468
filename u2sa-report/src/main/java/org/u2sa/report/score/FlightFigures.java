package org.u2sa.report.score;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Metrics of aircraft only. Empty if the flight was never in a state in which they are measured.
 *
 * @param altitudeRmsM RMS over time of the altitude error on level legs [m], i.e. between waypoints
 *     of equal altitude
 * @param altitudeMaxErrorM largest absolute altitude error on level legs [m]
 * @param maxBankRad largest absolute bank in the air [rad]
 * @param minAirspeedMps minimum calibrated airspeed in the air [m/s]
 * @param tookOff whether the vehicle left the ground and rose {@link #SCREEN_HEIGHT_M} above its
 *     start
 */
public record FlightFigures(
    OptionalDouble altitudeRmsM,
    OptionalDouble altitudeMaxErrorM,
    OptionalDouble maxBankRad,
    OptionalDouble minAirspeedMps,
    boolean tookOff) {
  /**
   * Height above the start at which an aircraft has taken off [m]: the screen height of 50 ft (CS
   * 23.2120).
   */
  public static final double SCREEN_HEIGHT_M = 15.24;

  private static final double LEVEL_WITHIN_M = 1.0; // altitude difference of a level leg's ends

  /** {@link #maxBankRad} in degrees. */
  public OptionalDouble maxBankDeg() {
    return maxBankRad.isPresent()
        ? OptionalDouble.of(Math.toDegrees(maxBankRad.getAsDouble()))
        : maxBankRad;
  }

  static FlightFigures of(RunPlan plan, List<TrackSample> track) {
    RootMeanSquare altitude = new RootMeanSquare();
    for (int leg = 1; leg < plan.waypoints().size(); leg++) {
      scoreAltitude(plan.waypoints().get(leg - 1), plan.waypoints().get(leg), leg, track, altitude);
    }
    Airborne air = Airborne.of(plan, track);
    return new FlightFigures(
        altitude.value(),
        altitude.largest(),
        air.maxBankRad(),
        air.minAirspeedMps(),
        air.tookOff());
  }

  private static void scoreAltitude(
      RunPlan.Waypoint from,
      RunPlan.Waypoint to,
      int leg,
      List<TrackSample> track,
      RootMeanSquare altitude) {
    if (!isLevel(from, to)) {
      return;
    }
    double planned = to.altitudeM().getAsDouble();
    for (int i = 0; i + 1 < track.size(); i++) {
      TrackSample a = track.get(i);
      if (a.leg() == leg) {
        TrackSample b = track.get(i + 1);
        altitude.add(b.timeS() - a.timeS(), a.altitudeM() - planned, b.altitudeM() - planned);
      }
    }
  }

  private static boolean isLevel(RunPlan.Waypoint from, RunPlan.Waypoint to) {
    OptionalDouble a = from.altitudeM();
    OptionalDouble b = to.altitudeM();
    return a.isPresent()
        && b.isPresent()
        && Math.abs(a.getAsDouble() - b.getAsDouble()) <= LEVEL_WITHIN_M;
  }

  /** Extremes above screen height, with weight off wheels. */
  private record Airborne(
      boolean tookOff, OptionalDouble maxBankRad, OptionalDouble minAirspeedMps) {
    static Airborne of(RunPlan plan, List<TrackSample> track) {
      if (track.isEmpty()) {
        return new Airborne(false, OptionalDouble.empty(), OptionalDouble.empty());
      }
      double ground = plan.home().map(RunPlan.Start::altitudeM).orElse(track.get(0).altitudeM());
      boolean tookOff = false;
      double bank = 0.0;
      double airspeed = Double.POSITIVE_INFINITY;
      for (TrackSample sample : track) {
        if (sample.flight().isEmpty() || sample.flight().get().onGround()) {
          continue;
        }
        TrackSample.Flight flight = sample.flight().get();
        tookOff |= sample.altitudeM() - ground >= SCREEN_HEIGHT_M;
        if (tookOff) {
          bank = Math.max(bank, Math.abs(flight.rollRad()));
          airspeed = Math.min(airspeed, flight.calibratedAirspeedMps());
        }
      }
      return new Airborne(
          tookOff,
          tookOff ? OptionalDouble.of(bank) : OptionalDouble.empty(),
          tookOff ? OptionalDouble.of(airspeed) : OptionalDouble.empty());
    }
  }
}
