package org.u2sa.cli.mission;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** A subcommand of {@code u2sa mission} that gives the Mission Manager one order. */
abstract class OrderCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  /** Order without request ID and operator. */
  abstract MissionOrder order();

  @Override
  public final Integer call() throws InterruptedException {
    return OrderToMissionManager.give(remote, order(), command.commandLine().getOut());
  }

  /** {@code u2sa mission goto}. */
  @Command(
      name = "goto",
      description = {
        "Pursue a goal now; the mission continues from there.",
        "",
        "resume returns to where the mission was."
      })
  static final class GoTo extends OrderCommand {
    @Parameters(paramLabel = "GOAL", description = "The goal; home if the mission has one.")
    private String goal;

    @Override
    MissionOrder order() {
      return new MissionOrder().action(MissionAction.GOTO).uid(goal);
    }
  }

  /** {@code u2sa mission skip}. */
  @Command(
      name = "skip",
      description = {"Skip a current goal: the mission continues as if it were done."})
  static final class Skip extends OrderCommand {
    @Parameters(
        arity = "0..1",
        paramLabel = "GOAL",
        description = "One of several current goals. Default: the only one.")
    private String goal;

    @Override
    MissionOrder order() {
      MissionOrder order = new MissionOrder().action(MissionAction.SKIP);
      return goal == null ? order : order.uid(goal);
    }
  }

  /** {@code u2sa mission update}. */
  @Command(
      name = "update",
      description = {
        "Change goals: the fields that a mission file gives replace those of the goals of the same names."
      })
  static final class Update extends OrderCommand {
    @Parameters(paramLabel = "FILE", description = "A mission file with the changed fields only.")
    private Path file;

    @Override
    MissionOrder order() {
      return OrderToMissionManager.withGoals(MissionAction.UPDATE, file);
    }
  }

  /** {@code u2sa mission pause}. */
  @Command(
      name = "pause",
      description = {
        "Pause the mission: the vehicle stops, or circles if it cannot stop. Time limits are paused too.",
        "",
        "resume continues with the same goal; goto and insert --now end the pause as well."
      })
  static final class Pause extends OrderCommand {
    @Override
    MissionOrder order() {
      return new MissionOrder().action(MissionAction.PAUSE);
    }
  }

  /** {@code u2sa mission resume}. */
  @Command(
      name = "resume",
      description = {
        "Continue a paused mission.",
        "",
        "If it is not paused: go back to where the mission was left, before goto or, with the variable RESUME = ORDERED, "
            + "by the previous process."
      })
  static final class Resume extends OrderCommand {
    @Override
    MissionOrder order() {
      return new MissionOrder().action(MissionAction.RESUME);
    }
  }
}
