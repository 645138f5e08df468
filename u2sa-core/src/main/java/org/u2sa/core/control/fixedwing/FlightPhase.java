package org.u2sa.core.control.fixedwing;

/** What the aircraft is at, from standing on the runway to following its mission. */
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
  /** In the air without navigation: wings level, after a while a wide circle; altitude held. */
  HOLD,
  /** On the ground for good: brakes on, engine idling. */
  STOPPED,
  /** Where navigation leads to the ground, the last metres: sink and power are taken away. */
  FLARE,
  /** Does not land, because of the wind: follows navigation sideways at the safe height. */
  GO_AROUND
}
