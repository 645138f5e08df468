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
            "Types of objects that stand still and serve as landmarks, separated by commas, such as \"buoy, gate\". Empty: all objects of WORLD that have a UID.")
        String landmarkTypes,
    @Variable(unit = "m", min = 0.001, max = 100, ifAbsent = 0.1)
        @Description("Standard deviation of the places in WORLD, in each axis.")
        double landmarkSigma,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether objects of LANDMARK TYPES that are not in WORLD become landmarks where they were first seen.")
        boolean learnLandmarks,
    @Variable(min = 1, max = 20, ifAbsent = 3)
        @Description(
            "Distance in standard deviations up to which a sighting without a known UID may be of a landmark, if no other is nearly as near.")
        double landmarkGate,
    @Variable(unit = "m", min = 0.001, max = 100, ifAbsent = 0.3)
        @Description("Standard deviation of a sighting that states none, in each axis.")
        double sightingSigma) {
  Set<String> types() {
    return Arrays.stream(landmarkTypes.split(","))
        .map(String::trim)
        .filter(type -> !type.isEmpty())
        .collect(Collectors.toSet());
  }
}
