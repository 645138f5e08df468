package org.u2sa.fuzz;

import org.u2sa.core.mission.Mission;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.GoalInformation;

/** Mission files. */
public final class MissionTarget {
  private MissionTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    try (InputFile file = InputFile.of(data)) {
      Mission mission = Mission.load(file.path());
      Agreement.require(!mission.goals().isEmpty(), "goals", mission.goals(), "one at least");
      for (GoalInformation goal : mission.goals()) {
        Agreement.require(goal.serialize().length > 0, "bytes", 0, "some");
      }
      Agreement.require(mission.warnings() != null, "warnings", null, "a list");
    } catch (BadInputException e) {
      OneLine.require(e);
    }
  }
}
