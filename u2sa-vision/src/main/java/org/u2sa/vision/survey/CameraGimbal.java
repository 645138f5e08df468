package org.u2sa.vision.survey;

import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;

/**
 * A gimbal with a roll and a pitch axis that keeps a camera level. Within its limits the camera
 * follows only the vehicle's heading; beyond a limit, it also tilts by the excess.
 *
 * @param limitRad largest angle of either axis, to both sides [rad]
 */
public record CameraGimbal(double limitRad) {
  /** Attitude of the camera's mount on a vehicle of this attitude. */
  public Attitude of(Attitude vehicle) {
    return new Attitude(beyond(vehicle.phi()), beyond(vehicle.theta()), vehicle.psi());
  }

  /** The state with roll and pitch of the camera's mount; it must have both. */
  StateInformation of(StateInformation state) {
    return state
        .copy()
        .phi(beyond(state.phi().orElseThrow()))
        .theta(beyond(state.theta().orElseThrow()));
  }

  private double beyond(double rad) {
    return rad - Math.max(-limitRad, Math.min(limitRad, rad));
  }
}
