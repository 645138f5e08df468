package org.u2sa.report.score;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Geodetic;

/**
 * Ground truth at one moment of a run (never an estimate, because scores are computed from it).
 *
 * @param timeS simulated time since the start of the run [s]
 * @param longitudeDeg longitude, WGS-84 [deg], east positive
 * @param latitudeDeg latitude, WGS-84 [deg], north positive
 * @param altitudeM altitude above mean sea level [m]
 * @param headingRad true heading [rad], clockwise from north
 * @param groundSpeedMps horizontal speed over ground [m/s]
 * @param crossTrackM distance from the line between the last waypoint and the target [m], right
 *     positive; empty if the vehicle is not on its way along one; only for the track file and the
 *     picture, not for the score
 * @param leg index of the target waypoint, from 0; −1 if none yet; number of waypoints if all are
 *     done
 * @param phase phase of the run, e.g. {@code CLIMB}
 * @param flight additional values of aircraft; empty for others
 */
public record TrackSample(
    double timeS,
    double longitudeDeg,
    double latitudeDeg,
    double altitudeM,
    double headingRad,
    double groundSpeedMps,
    OptionalDouble crossTrackM,
    int leg,
    String phase,
    Optional<Flight> flight) {

  /**
   * An aircraft's attitude and airspeed.
   *
   * @param rollRad roll [rad], right wing down positive
   * @param pitchRad pitch [rad], nose up positive
   * @param calibratedAirspeedMps calibrated airspeed [m/s]
   * @param onGround weight on wheels; always false for simulators that do not report it
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
    crossTrackM.ifPresent(metres -> finite("crossTrackM", metres));
    if (leg < -1) {
      throw new IllegalArgumentException("leg: " + leg + ", expected -1 or more");
    }
  }

  /** Copy with another target, on no line. */
  TrackSample towards(int target) {
    return new TrackSample(
        timeS,
        longitudeDeg,
        latitudeDeg,
        altitudeM,
        headingRad,
        groundSpeedMps,
        OptionalDouble.empty(),
        target,
        phase,
        flight);
  }

  Geodetic place() {
    return new Geodetic(longitudeDeg, latitudeDeg, altitudeM);
  }

  private static void finite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + ": " + value + " is not a finite number");
    }
  }
}
