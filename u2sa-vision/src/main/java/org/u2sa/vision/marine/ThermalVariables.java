package org.u2sa.vision.marine;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Detection settings of a {@link ThermalCamera}. */
record ThermalVariables(
    @Variable(ifAbsentText = "")
        @Description(
            "Kinds always looked for, regardless of the current goal: HotTarget, or empty.")
        String always,
    @Variable(ifAbsentText = "")
        @Description(
            "Kinds needed by goal classes that do not name them, such as \"Waypoint: ; HotTargetGoal: HotTarget\".")
        String kindsByGoal,
    @Variable(unit = "K", min = 100, max = 2000, ifAbsent = 268.15)
        @Description("Temperature shown as black.")
        double coldest,
    @Variable(unit = "K", min = 101, max = 3000, ifAbsent = 328.15)
        @Description("Temperature shown as white.")
        double hottest,
    @Variable(unit = "rad", min = 0.17, max = 2.8, ifAbsent = 0.8)
        @Description("Horizontal angle of view, for a camera that does not report its geometry.")
        double angleOfView,
    @Variable(unit = "K", min = 200, max = 400, ifAbsent = 295.15)
        @Description("Temperature of the air, which unheated objects have.")
        double airTemperature,
    @Variable(unit = "K", min = 0.5, max = 1000, ifAbsent = 6)
        @Description("Minimum temperature of a target above the air's.")
        double minExcess,
    @Variable(unit = "m", min = 0.02, max = 10, ifAbsent = 0.5) @Description("Height of targets.")
        double targetHeight,
    @Variable(unit = "m", min = 0.02, max = 10, ifAbsent = 0.5) @Description("Width of targets.")
        double targetWidth,
    @Variable(min = 0, max = 1, ifAbsent = 0.05)
        @Description("Relative standard deviation of the height.")
        double sizeSigma,
    @Variable(min = 0.1, max = 20, ifAbsent = 0.8)
        @Description("Standard deviation of an apparent size, in pixels.")
        double pixelSigma,
    @Variable(unit = "rad", min = 0, max = 0.2, ifAbsent = 0.006)
        @Description("Standard deviation of the camera's direction.")
        double angleSigma,
    @Variable(unit = "m", min = 0.5, max = 1000, ifAbsent = 30)
        @Description("Distance beyond which no target is reported.")
        double maxDistance) {
  /**
   * @throws IllegalArgumentException if the range of temperatures is empty
   */
  ThermalVariables {
    if (!(hottest > coldest)) {
      throw new IllegalArgumentException(
          "HOTTEST, " + hottest + " K, is not above COLDEST, " + coldest + " K");
    }
  }
}
