package org.u2sa.planning.guidance;

/**
 * Settings of line following.
 *
 * @param leastLookAheadM minimum look-ahead [m]
 * @param lookAheadS look-ahead time of a fast vehicle, multiplied by its ground speed [s]
 * @param turns turn performance of the vehicle
 * @param altitudes how altitude changes along a leg
 */
public record LineSettings(
    double leastLookAheadM, double lookAheadS, TurnAnticipation turns, AltitudeProfile altitudes) {
  /** Look-ahead from the vehicle's projection on its leg to the target point [m]. */
  public double lookAheadM(double speedMps) {
    return Math.max(leastLookAheadM, lookAheadS * speedMps);
  }

  /** Altitude profile along a leg. */
  public enum AltitudeProfile {
    /** Changes immediately to the altitude of the leg's end. */
    IMMEDIATE {
      @Override
      Slope along(Place start, Place end, Vehicle vehicle, double targetDownM) {
        return share -> targetDownM;
      }
    },
    /**
     * Changes in proportion to the distance along the leg if both ends have an altitude, otherwise
     * immediately.
     */
    LINEAR {
      @Override
      Slope along(Place start, Place end, Vehicle vehicle, double targetDownM) {
        if (start.upM().isEmpty() || end.upM().isEmpty()) {
          return share -> targetDownM;
        }
        double from = vehicle.nedOf(start).z();
        double to = vehicle.nedOf(end).z();
        return share -> from + Math.max(0.0, Math.min(1.0, share)) * (to - from);
      }
    };

    interface Slope {
      /** Depth of the path below the vehicle [m], at a fraction of the leg's length. */
      double downM(double share);
    }

    /**
     * Altitudes between two positions.
     *
     * @param targetDownM depth of the current target below the vehicle [m]
     */
    abstract Slope along(Place start, Place end, Vehicle vehicle, double targetDownM);
  }
}
