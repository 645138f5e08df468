package org.u2sa.mission;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** The variables of the {@link MissionManager}, besides its {@link MissionManager.Defaults}. */
record MissionVariables(
    @Variable
        @Description(
            "Mission XML file, relative to the configuration file. If changed while running, the new mission starts.")
        String mission,
    @Variable(ifAbsentText = "false")
        @Description("Whether the mission repeats (as in thesis 4.5.2.3).")
        boolean loop,
    @Variable(ifAbsentText = "ALL")
        @Description(
            "Whether ALL of several next goals must be finished before the mission continues, or ANY one.")
        GoalSequence.Options options,
    @Variable(ifAbsentText = "")
        @Description(
            "Mission XML file for the failsafe RETURN, relative to the configuration file; empty: return to the mission's home.")
        String returnMission,
    @Variable(ifAbsentText = "")
        @Description(
            "Mission XML file for the failsafe LAND, relative to the configuration file; empty: return instead.")
        String landMission,
    @Variable(ifAbsentText = "NEVER")
        @Description(
            "Whether a restarted process resumes the mission where this one ended: ALWAYS, when ORDERED by resume, or NEVER.")
        Resumption resume) {
  /** Whether a mission continues after a restart in another process. */
  enum Resumption {
    /** Restarts the mission; progress is not saved. */
    NEVER,
    /** Starts over; resumed on order. */
    ORDERED,
    /** Resumed immediately. */
    ALWAYS
  }

  static final String MISSION = "MISSION";
  static final String RETURN_MISSION = "RETURN MISSION";
  static final String LAND_MISSION = "LAND MISSION";
  static final String DEFAULT_THRESHOLD = "DEFAULT THRESHOLD";
}
