package org.u2sa.core.mission;

import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The variables of the {@link MissionManager}. */
final class MissionVariables {
  static final VariableDeclaration<String> MISSION =
      VariableDeclaration.text("MISSION")
          .describedAs(
              "The mission's XML file, relative to the configuration file. Changed while running: the new mission begins.");

  static final VariableDeclaration<Boolean> LOOP =
      VariableDeclaration.flag("LOOP")
          .ifAbsent(false)
          .describedAs(
              "Whether the mission begins anew after its last goal (thesis 4.5.2.3 did for ever).");

  static final VariableDeclaration<String> OPTIONS =
      VariableDeclaration.text("OPTIONS")
          .oneOf(GoalSequence.Options.ALL.name(), GoalSequence.Options.ANY.name())
          .ifAbsent(GoalSequence.Options.ALL.name())
          .describedAs(
              "Of several next goals, whether ALL are to be finished before what follows, or ANY one.");

  /** Without a default: what is near enough for an aircraft is another place for a rover. */
  static final VariableDeclaration<Double> DEFAULT_THRESHOLD =
      VariableDeclaration.number("DEFAULT THRESHOLD", "m")
          .range(Range.positive())
          .describedAs("Horizontal threshold of waypoints that give none.");

  private MissionVariables() {}
}
