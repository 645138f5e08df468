package org.u2sa.planning.avoidance;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;

/** Turns the sensors of a {@link Searching} vehicle to the right step by step. */
final class LookingAround {
  private static final double STEP_RAD = Math.toRadians(60.0);
  private static final long STEP_MICROS = 5 * Clock.MICROS_PER_SECOND / 2; // in each direction

  private long turnedMicros = Long.MIN_VALUE;
  private double toRad;

  ArcChoice choose(ArcChooser arcs, Situation now) {
    if (turnedMicros == Long.MIN_VALUE || now.micros() - turnedMicros > STEP_MICROS) {
      turnedMicros = now.micros();
      toRad = Pose.wrapped(now.pose().headingRad() + STEP_RAD);
    }
    return arcs.lookTo(toRad);
  }
}
