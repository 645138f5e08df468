package org.u2sa.vision.camera;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Detection settings of a {@link CourseCamera}. */
public record CourseVariables(
    @Variable(ifAbsentText = "")
        @Description(
            "Calibration file of the camera, relative to the configuration file (u2sa camera calibrate); empty: the geometry reported by the camera, or ANGLE OF VIEW.")
        String calibration,
    @Variable(unit = "rad", min = 0.17, max = 2.8, ifAbsent = 1.05)
        @Description(
            "Horizontal angle of view, for a camera that is neither calibrated nor reports its geometry.")
        double angleOfView,
    @Variable(unit = "m", min = -10, max = 10, ifAbsent = 0)
        @Description("Height of the vehicle's reference point above the ground.")
        double groundBelow,
    @Variable(ifAbsentText = "true")
        @Description(
            "Whether the ground is level and the vehicle rolls and pitches on it; otherwise the ground tilts with the vehicle.")
        boolean levelGround,
    @Variable(unit = "rad", min = 0.001, max = 1.6, ifAbsent = 1.6)
        @Description(
            "Tilt above which the vehicle is assumed to be on a slope, fully at twice this tilt: the ground ahead may slope or be level, so standard deviations of positions on it grow.")
        double slopeAbove,
    @Variable(unit = "m", min = 0, max = 50, ifAbsent = 0.5)
        @Description("Minimum distance of searched ground ahead of the reference point.")
        double nearest,
    @Variable(unit = "m", min = 1, max = 50, ifAbsent = 7)
        @Description("Maximum distance of ground searched for paint.")
        double farthest,
    @Variable(unit = "m", min = 0.5, max = 50, ifAbsent = 4)
        @Description("Lateral range searched for paint, to each side.")
        double toEachSide,
    @Variable(unit = "m", min = 0.02, max = 0.5, ifAbsent = 0.0762)
        @Description("Width of painted lines.")
        double lineWidth,
    @Variable(min = 0.02, max = 3, ifAbsent = 0.16)
        @Description(
            "Minimum brightness of paint relative to the ground on both sides: 0.16 is 16 % more.")
        double contrast,
    @Variable(min = 1, max = 20, ifAbsent = 3.5)
        @Description(
            "Minimum brightness of paint relative to the ground, in standard deviations of the ground's texture.")
        double noiseFactor,
    @Variable(unit = "m", min = 0.1, max = 10, ifAbsent = 0.6)
        @Description("Minimum length of a line to report.")
        double minLineLength,
    @Variable(unit = "m", min = 0, max = 5, ifAbsent = 0.6)
        @Description("Maximum gap of worn paint that a line bridges.")
        double maxGap,
    @Variable(unit = "m", min = 0.5, max = 100, ifAbsent = 2)
        @Description("Maximum length of a line reported in one piece; longer ones are cut.")
        double maxPieceLength,
    @Variable(unit = "m", min = 0.05, max = 2, ifAbsent = 0.305)
        @Description("Radius of the white discs that mark potholes.")
        double potholeRadius,
    @Variable(unit = "m", min = 0.1, max = 3, ifAbsent = 0.6) @Description("Diameter of a barrel.")
        double barrelWidth,
    @Variable(unit = "m", min = 0.2, max = 3, ifAbsent = 1) @Description("Height of a barrel.")
        double barrelHeight,
    @Variable(unit = "m", min = 0, max = 1, ifAbsent = 0.08)
        @Description("Height of a barrel's lowest orange stripe above the ground.")
        double barrelBase,
    @Variable(unit = "m", min = 0.3, max = 5, ifAbsent = 1.2)
        @Description("Length of a sawhorse's plank.")
        double sawhorseWidth,
    @Variable(unit = "m", min = 0, max = 2, ifAbsent = 0.3)
        @Description("Height of the lower edge of a sawhorse's lowest plank above the ground.")
        double sawhorseClear,
    @Variable(unit = "m", min = 0.05, max = 2, ifAbsent = 0.32)
        @Description("Width of a flag's cloth.")
        double flagWidth,
    @Variable(unit = "m", min = 0.05, max = 2, ifAbsent = 0.26)
        @Description("Height of a flag's cloth.")
        double flagCloth,
    @Variable(unit = "m", min = 0.1, max = 5, ifAbsent = 1)
        @Description("Height of a flag's upper edge above the ground.")
        double flagTop,
    @Variable(unit = "m", min = 1, max = 100, ifAbsent = 12)
        @Description("Distance beyond which no object is reported.")
        double maxObjectDistance,
    @Variable(min = 0.1, max = 20, ifAbsent = 1)
        @Description("Standard deviation of image positions, in pixels.")
        double pixelSigma,
    @Variable(unit = "rad", min = 0, max = 0.2, ifAbsent = 0.008)
        @Description("Standard deviation of the camera's pitch and roll relative to the ground.")
        double tiltSigma,
    @Variable(unit = "rad", min = 0, max = 0.2, ifAbsent = 0.008)
        @Description("Standard deviation of the camera's direction.")
        double yawSigma,
    @Variable(unit = "m", min = 0, max = 1, ifAbsent = 0.02)
        @Description("Distance-independent position error, 1 sigma.")
        double ownSigma) {
  private static final double CELLS_A_LINE = 3.0;

  /**
   * @throws IllegalArgumentException if the observed ground area is empty
   */
  public CourseVariables {
    if (!(farthest > nearest)) {
      throw new IllegalArgumentException(
          "FARTHEST, " + farthest + " m, is not beyond NEAREST, " + nearest + " m");
    }
  }

  /** Cell size of the ground view: a third of a line's width [m]. */
  double cellM() {
    return lineWidth / CELLS_A_LINE;
  }
}
