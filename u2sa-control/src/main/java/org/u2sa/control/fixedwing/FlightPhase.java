package org.u2sa.control.fixedwing;

/** Flight phase, from standing on the runway to following the mission. */
public enum FlightPhase {
  /** Standing on the brakes: waits for engine and navigation, then opens the throttle. */
  RUN_UP,
  /** Rolling along the centreline. */
  ROLL,
  /** Raising the nose. */
  ROTATE,
  /** Climbing straight ahead at full throttle. */
  CLIMB_OUT,
  /** Following navigation. */
  CRUISE,
  /** Airborne without navigation: wings level, after a while a wide circle, holding altitude. */
  HOLD,
  /** Stopped after landing: brakes on, engine idling. */
  STOPPED,
  /** Last metres of a landing: sink rate and power are reduced. */
  FLARE,
  /** Landing refused because of wind: follows navigation laterally at the safe height. */
  GO_AROUND
}
