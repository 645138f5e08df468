package org.u2sa.control.fixedwing;

import org.u2sa.control.fixedwing.law.FlightState;
import org.u2sa.control.fixedwing.law.GroundSteering;
import org.u2sa.control.fixedwing.law.Limit;
import org.u2sa.control.fixedwing.law.StallGuard;

/** Ground phases before flight: run-up and take-off run. */
final class GroundPhases {
  private final AutopilotVariables tuning;
  private final TakeOffSequence sequence;
  private final GroundSteering steering;
  private final InnerLoops loops;
  private final StallGuard stall;
  private final TakeOffRotation rotation;

  GroundPhases(
      AutopilotVariables tuning,
      TakeOffSequence sequence,
      GroundSteering steering,
      InnerLoops loops,
      TakeOffRotation rotation) {
    this.tuning = tuning;
    this.sequence = sequence;
    this.steering = steering;
    this.loops = loops;
    stall = new StallGuard(tuning.guidance());
    this.rotation = rotation;
  }

  Surfaces runUp(FlightState state, boolean navigating, double dtS) {
    steering.lineUp(state);
    double wanted = 0.0;
    if (!sequence.engineReady(state)) {
      wanted = tuning.climbOut().startThrottle();
    } else if (navigating && sequence.cleared(state)) {
      wanted = 1.0;
    }
    loops.throttleTowards(wanted, dtS);
    loops.rudder(0.0);
    return new Surfaces(steering.aileron(state), 0.0, 0.0, loops.throttle(), 1.0, 0.0, 1.0);
  }

  /**
   * @param rotating whether to raise the nose
   */
  Surfaces run(FlightState state, boolean rotating, double dtS) {
    loops.throttleTowards(1.0, dtS);
    loops.rudder(steering.rudder(state, !rotating, dtS));
    double elevator = 0.0;
    double level = 0.0;
    if (rotating) {
      double step = Math.toRadians(tuning.climbOut().rotationRate()) * dtS;
      double pitch = Limit.approach(loops.pitchRad(), rotation.pitchRad(), step);
      loops.pitch(Math.min(pitch, stall.pitchLimitRad(state)));
      elevator = loops.elevator(state, dtS);
      level = loops.levelAileron(state, dtS);
    }
    double aileron = Limit.symmetric(steering.aileron(state) + level, 1.0);
    return new Surfaces(aileron, elevator, loops.rudder(), loops.throttle(), 1.0, 0.0, 0.0);
  }
}
