package org.u2sa.world.scanmap;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Variables of the modeller {@code SCAN MAP}. */
record ScanMapVariables(
    @Variable(ifAbsentText = "true")
        @Description(
            "Whether SCAN MAP publishes the pose of each matched scan on sensed-state, so that the State Estimator can use it to correct the state.")
        boolean correctState,
    @Variable(ifAbsentText = "")
        @Description(
            "Where the vehicle starts on the map: x and y [m] and heading [deg], such as \"0 0 90\"; published in LOCAL_NED until a state arrives. Empty: taken from the first state.")
        String mapStart,
    @Variable(unit = "m", min = 0.001, max = 100, ifAbsent = 0.05)
        @Description("Standard deviation of the position in MAP START; with MAP FILE at most 5 m.")
        double mapStartSigma,
    @Variable(unit = "deg", min = 0.01, max = 90, ifAbsent = 1)
        @Description("Standard deviation of the heading in MAP START.")
        double mapStartPsiSigma,
    @Variable(ifAbsentText = "")
        @Description(
            "Saved map for localisation, in which the vehicle is searched for within 3 sigma of its start; relative to the configuration file; it is not modified. Empty: the map is built from the first scan on.")
        String mapFile,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0.05)
        @Description("Standard deviation of positions on the map of MAP FILE.")
        double mapSigma,
    @Variable(ifAbsentText = "")
        @Description(
            "File to which the map is written when the World Modeler stops, relative to the configuration file; replaces maps only. Empty: it is not saved.")
        String saveMap,
    @Variable(ifAbsentText = "true")
        @Description("Whether to detect and close loops when the vehicle revisits a place.")
        boolean closeLoops,
    @Variable(unit = "m", min = 1, max = 60, ifAbsent = 25)
        @Description("Range beyond which echoes are not matched.")
        double matchReach,
    @Variable(min = 20, max = 2000, ifAbsent = 400)
        @Description("Maximum number of echoes to match per scan; more echoes take more time.")
        int matchPoints,
    @Variable(min = 0, max = 1, ifAbsent = 0.3)
        @Description("Minimum fraction of a scan's echoes that must lie on surfaces of the map.")
        double minShare,
    @Variable(unit = "m", min = 0.05, max = 10, ifAbsent = 0.5)
        @Description("Distance travelled after which a scan is added to the map.")
        double keyDistance,
    @Variable(unit = "deg", min = 1, max = 180, ifAbsent = 20)
        @Description("Heading change after which a scan is added to the map.")
        double keyTurn,
    @Variable(min = 0, max = 2, ifAbsent = 0.1)
        @Description("Standard deviation of the dead-reckoned distance, as a fraction of it.")
        double wayNoise,
    @Variable(min = 0, max = 2, ifAbsent = 0.2)
        @Description("Standard deviation of a dead-reckoned turn, as a fraction of it.")
        double turnNoise,
    @Variable(unit = "deg/m", min = 0, max = 45, ifAbsent = 1)
        @Description("Standard deviation of the dead-reckoned heading per metre travelled.")
        double headingNoise) {
  /** Validates MAP START. */
  ScanMapVariables {
    boolean isGiven = numbers(mapStart).length > 0;
    if (isGiven && !mapFile.isEmpty() && mapStartSigma > Relocation.MAX_SIGMA_M) {
      throw new IllegalArgumentException(
          "MAP START SIGMA: "
              + mapStartSigma
              + " m is too much for a saved map: at most "
              + Relocation.MAX_SIGMA_M
              + " m around MAP START are searched");
    }
  }

  private static double[] numbers(String text) {
    if (text.trim().isEmpty()) {
      return new double[0];
    }
    String[] parts = text.trim().split("\\s+");
    double[] numbers = new double[parts.length];
    try {
      for (int i = 0; i < parts.length; i++) {
        numbers[i] = Double.parseDouble(parts[i]);
      }
    } catch (NumberFormatException e) {
      numbers = new double[0];
    }
    if (numbers.length != 3 || !Double.isFinite(numbers[0] + numbers[1] + numbers[2])) {
      throw new IllegalArgumentException(
          "MAP START: \"" + text + "\" is not three numbers: x and y [m] and heading [deg]");
    }
    return numbers;
  }

  /** North and east [m] and heading [rad] of MAP START; empty if not set. */
  double[] start() {
    double[] numbers = numbers(mapStart);
    if (numbers.length > 0) {
      numbers[2] = Math.toRadians(numbers[2]);
    }
    return numbers;
  }
}
