package org.u2sa.fuzz;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.mission.Mission;

/** Mission files. */
public final class MissionTarget {
  private static final MessageTypes TYPES = MessageTypes.discovered();
  private static final double THRESHOLD_M = 1.0; // as a vehicle's configuration gives it

  private MissionTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    try (InputFile file = InputFile.of(data)) {
      Mission mission = Mission.load(file.path(), TYPES, THRESHOLD_M);
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
