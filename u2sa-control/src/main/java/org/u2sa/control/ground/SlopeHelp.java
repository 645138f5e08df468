package org.u2sa.control.ground;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;

/**
 * Feed-forward of motor power on slopes, from the vehicle's pitch: feedback alone takes seconds, so
 * the vehicle would stop before a ramp and run away after it.
 */
record SlopeHelp(
    @Variable(unit = "%", min = 0, max = 5000, ifAbsent = 0)
        @Description(
            "Percentage that holds the vehicle on a slope, per sine of the slope: weight divided by the motors' stall force; 0: left to SPEED GAIN.")
        double slopeHelp) {
  private static final double FULL_PERCENT = 100.0;
  private static final double LEVEL_RAD = 0.026; // dead band for uneven ground and sensor errors
  private static final double SLOPE_RAD = 0.052; // full effect from this slope on

  /** Share of full power to add to both sides, forward positive. */
  double share(StateInformation state) {
    double pitch = state.theta().orElse(0.0);
    double counts = (Math.abs(pitch) - LEVEL_RAD) / (SLOPE_RAD - LEVEL_RAD);
    return slopeHelp / FULL_PERCENT * Math.max(0.0, Math.min(1.0, counts)) * Math.sin(pitch);
  }
}
