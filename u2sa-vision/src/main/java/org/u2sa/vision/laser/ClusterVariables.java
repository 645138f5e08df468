package org.u2sa.vision.laser;

import org.u2sa.interfaces.configuration.Variable;

/** Settings of {@link ScanClusters}. */
record ClusterVariables(
    @Variable(
            unit = "m",
            min = 0.01,
            max = 10,
            ifAbsent = 0.25,
            text = "Distance between two neighbouring echoes of one thing, at most.")
        double gap,
    @Variable(
            min = 1,
            max = 1000,
            ifAbsent = 3,
            text = "Fewest echoes of a thing: what has fewer is noise.")
        int fewestEchoes,
    @Variable(
            unit = "m",
            min = 0.05,
            max = 100,
            ifAbsent = 1.5,
            text = "Largest thing, end to end: what is larger is a wall and stays with the grid.")
        double largest,
    @Variable(
            unit = "m",
            min = 0.01,
            max = 10,
            ifAbsent = 0.05,
            text = "Smallest radius of a circle that is fitted.")
        double smallestRadius,
    @Variable(
            unit = "m",
            min = 0.01,
            max = 10,
            ifAbsent = 0.5,
            text = "Largest radius of a circle that is fitted.")
        double largestRadius,
    @Variable(
            unit = "m",
            min = 0.001,
            max = 1,
            ifAbsent = 0.02,
            text = "Standard deviation of an echo's range.")
        double rangeSigma,
    @Variable(
            unit = "m",
            min = -10,
            max = 10,
            ifAbsent = 0,
            text = "How far below the vehicle's reference point the ground is.")
        double groundBelow,
    @Variable(
            unit = "m",
            min = -10,
            max = 10,
            ifAbsent = 0.1,
            text = "Height above level ground below which an echo is the ground itself.")
        double lowest) {
  /**
   * @throws IllegalArgumentException if the radius range is empty
   */
  ClusterVariables {
    if (!(largestRadius > smallestRadius)) {
      throw new IllegalArgumentException(
          "LARGEST RADIUS, "
              + largestRadius
              + " m, is not above SMALLEST RADIUS, "
              + smallestRadius
              + " m");
    }
  }
}
