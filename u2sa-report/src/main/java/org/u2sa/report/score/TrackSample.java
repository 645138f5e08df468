package org.u2sa.report.score;

import java.util.Optional;

/**
 * Truth at one moment of a run (never an estimate: scores are computed from it).
 *
 * @param timeS simulated time since the start of the run [s]
 * @param longitudeDeg longitude, WGS-84 [deg], east positive
 * @param latitudeDeg latitude, WGS-84 [deg], north positive
 * @param altitudeM altitude above mean sea level [m]
 * @param headingRad true heading [rad], clockwise from north
 * @param groundSpeedMps horizontal speed over ground [m/s]
 * @param crossTrackM distance from the line to the target as the vehicle's guidance saw it [m],
 *     right of it positive; kept for the track file and the picture only, the score measures for
 *     itself
 * @param leg index of the waypoint that was the target, from 0; −1: none yet; number of waypoints:
 *     all done
 * @param phase what the vehicle was doing, e.g. {@code CLIMB}
 * @param flight what aircraft have besides; empty for others
 */
public record TrackSample(
    double timeS,
    double longitudeDeg,
    double latitudeDeg,
    double altitudeM,
    double headingRad,
    double groundSpeedMps,
    double crossTrackM,
    int leg,
    String phase,
    Optional<Flight> flight) {

  /**
   * An aircraft's attitude and airspeed.
   *
   * @param rollRad roll [rad], right wing down positive
   * @param pitchRad pitch [rad], nose up positive
   * @param calibratedAirspeedMps calibrated airspeed [m/s]
   * @param onGround whether wheels carry weight; always false from simulators that cannot tell
   */
  public record Flight(
      double rollRad, double pitchRad, double calibratedAirspeedMps, boolean onGround) {

    /**
     * @throws IllegalArgumentException if a number is not finite
     */
    public Flight {
      finite("rollRad", rollRad);
      finite("pitchRad", pitchRad);
      finite("calibratedAirspeedMps", calibratedAirspeedMps);
    }
  }

  /**
   * @throws IllegalArgumentException if a number is not finite, or leg is less than −1
   */
  public TrackSample {
    finite("timeS", timeS);
    finite("longitudeDeg", longitudeDeg);
    finite("latitudeDeg", latitudeDeg);
    finite("altitudeM", altitudeM);
    finite("headingRad", headingRad);
    finite("groundSpeedMps", groundSpeedMps);
    finite("crossTrackM", crossTrackM);
    if (leg < -1) {
      throw new IllegalArgumentException("leg: " + leg + ", expected -1 or more");
    }
  }

  private static void finite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + ": " + value + " is not a finite number");
    }
  }
}
