package org.u2sa.core.mission;

import org.u2sa.interfaces.configuration.Variable;

/** The variables of the {@link MissionManager}, besides its {@link MissionManager.Defaults}. */
record MissionSettings(
    @Variable(
            text =
                "The mission's XML file, relative to the configuration file. Changed while running: the new mission begins.")
        String mission,
    @Variable(
            ifAbsentText = "false",
            text =
                "Whether the mission begins anew after its last goal (thesis 4.5.2.3 did for ever).")
        boolean loop,
    @Variable(
            ifAbsentText = "ALL",
            text =
                "Of several next goals, whether ALL are to be finished before what follows, or ANY one.")
        GoalSequence.Options options,
    @Variable(
            ifAbsentText = "",
            text =
                "The mission's XML file for the failsafe RETURN, relative to the configuration file; empty: to the mission's home.")
        String returnMission,
    @Variable(
            ifAbsentText = "",
            text =
                "The mission's XML file for the failsafe LAND, relative to the configuration file; empty: it returns instead.")
        String landMission) {
  static final String MISSION = "MISSION";
  static final String RETURN_MISSION = "RETURN MISSION";
  static final String LAND_MISSION = "LAND MISSION";
  static final String DEFAULT_THRESHOLD = "DEFAULT THRESHOLD";
}
