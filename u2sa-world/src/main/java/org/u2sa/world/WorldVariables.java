package org.u2sa.world;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/** Variables of the {@link WorldModeler} itself; each modeller has its own. */
record WorldVariables(
    @Variable(ifAbsentText = "OBJECTS, GRID")
        @Description(
            "Active modellers, separated by commas: REACTIVE (newest of each sensor), OBJECTS (object map), GRID (occupancy grid), SCAN MAP (grid from matched scans, which correct the state), LANDMARKS (landmarks correct the state), BEARINGS (objects by direction), EGOCENTRIC (objects relative to the vehicle), LINES (painted lines), or an extension's.")
        String modellers,
    @Variable(ifAbsentText = "")
        @Description(
            "World XML file with objects known beforehand, relative to the configuration file; empty: none.")
        String world,
    @Variable(ifAbsentText = "true")
        @Description(
            "Whether moving objects of WORLD are also known beforehand; false: sensors have to detect them, like uncharted traffic.")
        boolean worldMovers,
    @Variable(unit = "Hz", min = 0.01, max = 100, ifAbsent = 2)
        @Description("Grids published per second, not more than RATE.")
        double gridRate,
    @Variable(ifAbsentText = "GOAL")
        @Description(
            "GOAL omits passable objects (HINDRANCE) of other types while every current goal names types of objects; ALL publishes everything.")
        Relevant relevant,
    @Variable(unit = "s", min = 0, max = 10, ifAbsent = 0.3)
        @Description(
            "Maximum time for which a measurement waits for the state at its time; then the newest state is extrapolated.")
        double waitForState,
    @Variable(unit = "s", min = 0.001, max = 10, ifAbsent = 0.5)
        @Description(
            "Maximum time between states for interpolating the pose of a measurement, and for extrapolating the newest state; otherwise the measurement is dropped.")
        double stateGap,
    @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 3)
        @Description("Time without a state after which the map continues in BODY.")
        double stateLostAfter,
    @Variable(ifAbsentText = "")
        @Description(
            "Names of required sensors, separated by commas; while one is silent, the Path Planner stops the vehicle. Empty: every scanner known so far and, with GRID among MODELLERS and no WORLD, at least one.")
        String expectedSensors,
    @Variable(unit = "s", min = 0.05, max = 3600, ifAbsent = 1)
        @Description("Age of its newest measurement at which an expected sensor counts as silent.")
        double silentAfter) {
  enum Relevant {
    GOAL,
    ALL
  }

  static final String MODELLERS = "MODELLERS";
  static final String WORLD = "WORLD";
  static final String WORLD_MOVERS = "WORLD MOVERS";

  /** Required sensors; empty: unnamed. */
  List<String> expected() {
    return Arrays.stream(expectedSensors.split(","))
        .map(String::trim)
        .filter(name -> !name.isEmpty())
        .collect(Collectors.toList());
  }

  long silentMicros() {
    return Clock.micros(silentAfter);
  }

  long waitMicros() {
    return Clock.micros(waitForState);
  }

  long gapMicros() {
    return Clock.micros(stateGap);
  }
}
