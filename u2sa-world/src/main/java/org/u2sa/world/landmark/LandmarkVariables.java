package org.u2sa.world.landmark;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Variables of the modeller {@code LANDMARKS}. */
record LandmarkVariables(
    @Variable(ifAbsentText = "")
        @Description(
            "Types of stationary objects that serve as landmarks, separated by commas, such as \"buoy, gate\". Empty: all objects of WORLD that have a UID.")
        String landmarkTypes,
    @Variable(unit = "m", min = 0.001, max = 100, ifAbsent = 0.1)
        @Description("Standard deviation of the positions in WORLD, per axis.")
        double landmarkSigma,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether objects of LANDMARK TYPES that are not in WORLD are learnt as landmarks at their first sighting.")
        boolean learnLandmarks,
    @Variable(min = 1, max = 20, ifAbsent = 3)
        @Description(
            "Association gate, in standard deviations, of a sighting without a known UID; ambiguous sightings are ignored.")
        double landmarkGate,
    @Variable(unit = "m", min = 0.001, max = 100, ifAbsent = 0.3)
        @Description("Default standard deviation of a sighting, per axis.")
        double sightingSigma) {
  Set<String> types() {
    return Arrays.stream(landmarkTypes.split(","))
        .map(String::trim)
        .filter(type -> !type.isEmpty())
        .collect(Collectors.toSet());
  }
}
