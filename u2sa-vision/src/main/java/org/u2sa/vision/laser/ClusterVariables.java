package org.u2sa.vision.laser;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Settings of {@link ScanClusters}. */
record ClusterVariables(
    @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.25)
        @Description("Maximum distance between neighbouring echoes of one object.")
        double gap,
    @Variable(min = 1, max = 1000, ifAbsent = 3)
        @Description("Minimum number of echoes of an object; fewer count as noise.")
        int minEchoes,
    @Variable(unit = "m", min = 0.05, max = 100, ifAbsent = 1.5)
        @Description(
            "Maximum extent of an object; larger ones are walls, which are left to the grid.")
        double largest,
    @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.05)
        @Description("Minimum radius of a fitted circle.")
        double minRadius,
    @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.5)
        @Description("Maximum radius of a fitted circle.")
        double maxRadius,
    @Variable(unit = "m", min = 0.001, max = 1, ifAbsent = 0.02)
        @Description("Standard deviation of an echo's range.")
        double rangeSigma,
    @Variable(unit = "m", min = -10, max = 10, ifAbsent = 0)
        @Description("Height of the vehicle's reference point above the ground.")
        double groundBelow,
    @Variable(unit = "m", min = -10, max = 10, ifAbsent = 0.1)
        @Description("Height above level ground below which an echo is the ground itself.")
        double lowest) {
  /**
   * @throws IllegalArgumentException if the radius range is empty
   */
  ClusterVariables {
    if (!(maxRadius > minRadius)) {
      throw new IllegalArgumentException(
          "MAX RADIUS, " + maxRadius + " m, is not above MIN RADIUS, " + minRadius + " m");
    }
  }
}
