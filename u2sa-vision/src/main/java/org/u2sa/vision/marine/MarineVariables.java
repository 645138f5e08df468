package org.u2sa.vision.marine;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Detection settings of a {@link MarineCamera}. */
record MarineVariables(
    @Variable(ifAbsentText = "Buoy")
        @Description(
            "Kinds of objects the camera can look for, separated by commas: Buoy, Pole, Hoop, Button, Dock, Bin, PathMarker.")
        String kinds,
    @Variable(ifAbsentText = "")
        @Description(
            "Kinds always looked for, regardless of the current goal, for example to be avoided.")
        String always,
    @Variable(ifAbsentText = "")
        @Description(
            "Kinds needed by goal classes that do not name them, such as \"Waypoint: Buoy; Docking: Dock, Button\".")
        String kindsByGoal,
    @Variable(ifAbsentText = "")
        @Description(
            "Calibration file of the camera, relative to the configuration file; empty: the geometry reported by the camera, or ANGLE OF VIEW.")
        String calibration,
    @Variable(unit = "rad", min = 0.17, max = 2.8, ifAbsent = 1.05)
        @Description(
            "Horizontal angle of view, for a camera that is neither calibrated nor reports its geometry.")
        double angleOfView,
    @Variable(ifAbsentText = "false") @Description("Whether the camera is under water.")
        boolean underWater,
    @Variable(unit = "1/m", min = 0, max = 10, ifAbsent = 0.3)
        @Description("Attenuation of red light by the water, under water only.")
        double redAttenuation,
    @Variable(unit = "1/m", min = 0, max = 10, ifAbsent = 0.1)
        @Description("Attenuation of green light by the water, under water only.")
        double greenAttenuation,
    @Variable(unit = "1/m", min = 0, max = 10, ifAbsent = 0.1)
        @Description("Attenuation of blue light by the water, under water only.")
        double blueAttenuation,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0)
        @Description(
            "Height of the vehicle's reference point above the water: a buoy's distance by size must agree with its angle below the horizon, which rejects reflections and glitter; 0: not checked.")
        double heightAboveWater,
    @Variable(unit = "rad", min = 0, max = 0.5, ifAbsent = 0.015)
        @Description("Standard deviation of the vehicle's roll and pitch, including waves.")
        double tiltSigma,
    @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.25) @Description("Radius of buoys.")
        double buoyRadius,
    @Variable(unit = "m", min = 0.1, max = 20, ifAbsent = 1.5)
        @Description("Visible height of poles.")
        double poleHeight,
    @Variable(unit = "m", min = 0.05, max = 10, ifAbsent = 0.5) @Description("Radius of hoops.")
        double hoopRadius,
    @Variable(unit = "m", min = 0.02, max = 5, ifAbsent = 0.4)
        @Description("Height and width of buttons.")
        double buttonSize,
    @Variable(unit = "m", min = 0.3, max = 100, ifAbsent = 3) @Description("Width of docks.")
        double dockWidth,
    @Variable(unit = "m", min = 0.05, max = 10, ifAbsent = 0.42)
        @Description("Length of a bin's coloured area.")
        double binLength,
    @Variable(unit = "m", min = 0.05, max = 10, ifAbsent = 0.28)
        @Description("Width of a bin's coloured area.")
        double binWidth,
    @Variable(unit = "m", min = 0.1, max = 10, ifAbsent = 1.2)
        @Description("Length of path markers.")
        double markerLength,
    @Variable(unit = "m", min = 0.02, max = 5, ifAbsent = 0.15)
        @Description("Width of path markers.")
        double markerWidth,
    @Variable(min = 0, max = 1, ifAbsent = 0.04)
        @Description("Relative standard deviation of these sizes.")
        double sizeSigma,
    @Variable(min = 0.1, max = 20, ifAbsent = 1.5)
        @Description("Standard deviation of an apparent size, in pixels.")
        double pixelSigma,
    @Variable(unit = "rad", min = 0, max = 0.2, ifAbsent = 0.006)
        @Description("Standard deviation of the camera's direction.")
        double angleSigma,
    @Variable(unit = "m", min = 0.5, max = 1000, ifAbsent = 25)
        @Description("Distance beyond which no object is reported.")
        double maxDistance) {
  /** Attenuation of red, green and blue [1/m]; 0 in air. */
  double[] attenuation() {
    return underWater
        ? new double[] {redAttenuation, greenAttenuation, blueAttenuation}
        : new double[3];
  }
}
