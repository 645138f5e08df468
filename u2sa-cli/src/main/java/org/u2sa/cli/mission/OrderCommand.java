package org.u2sa.cli.mission;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.UUID;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.Unanswered;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** A subcommand of {@code u2sa mission} that gives the Mission Manager one order. */
abstract class OrderCommand extends BaseCommand {
  @Mixin private RemoteSystem remote;

  /** The order, without request ID and operator. */
  abstract MissionOrder order();

  @Override
  public final Integer call() throws InterruptedException {
    String id = UUID.randomUUID().toString();
    MissionOrder order = order().requestId(id).operator(Operator.name());
    boolean isPause = order.action() == MissionAction.PAUSE; // obeyed whatever its age: at once
    try (RemoteLink link = isPause ? remote.connect() : remote.connectForOrders()) {
      Optional<MissionOrderResult> result =
          link.first(
              Channels.MISSION,
              order,
              MissionOrderResult.class,
              each -> each.requestId().equals(id));
      if (result.isEmpty()) {
        boolean lasts = order.action() == MissionAction.PAUSE;
        String later = lasts ? Unanswered.LASTING : Unanswered.EXPIRING;
        throw remote.unanswered(link, ShowMissionCommand.nobody(link) + "; " + later);
      }
      if (!result.get().accepted()) {
        throw new RunFailedException(
            order.action() + " was not carried out: " + result.get().outcome());
      }
      print(link.systemId() + ": " + result.get().outcome());
      return ExitCode.DONE;
    }
  }

  /**
   * Creates an order with goals.
   *
   * @param file a mission file with goals only; parsed by the Mission Manager, which knows the goal
   *     classes
   * @throws BadInputException if it is not a mission file
   */
  private static MissionOrder withGoals(MissionAction action, Path file) {
    XmlReader.read(file, "mission");
    try {
      return new MissionOrder().action(action).goals(Files.readString(file)).file(file.toString());
    } catch (CharacterCodingException e) {
      throw new BadInputException(file + ": must be encoded in UTF-8", e);
    } catch (IOException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
  }

  @Command(
      name = "goto",
      description = {
        "Pursue a goal now; the mission continues from there.",
        "",
        "resume returns to the interrupted goal."
      })
  static final class GoTo extends OrderCommand {
    @Parameters(paramLabel = "GOAL", description = "The goal; also home, if the mission has one.")
    private String goal;

    @Override
    MissionOrder order() {
      return new MissionOrder().action(MissionAction.GOTO).uid(goal);
    }
  }

  @Command(
      name = "skip",
      description = {"Skip a current goal: the mission continues as if it had been completed."})
  static final class Skip extends OrderCommand {
    @Parameters(
        arity = "0..1",
        paramLabel = "GOAL",
        description = "One of several current goals. Default: the only current goal.")
    private String goal;

    @Override
    MissionOrder order() {
      MissionOrder order = new MissionOrder().action(MissionAction.SKIP);
      return goal == null ? order : order.uid(goal);
    }
  }

  @Command(
      name = "insert",
      description = {
        "Insert the goals of a mission file.",
        "",
        "The successors of that goal become their successors. Names must be new; a next may name goals of "
            + "the mission."
      })
  static final class Insert extends OrderCommand {
    @Parameters(paramLabel = "FILE", description = "A mission file with goals only.")
    private Path file;

    @ArgGroup private Place place = new Place();

    private static final class Place {
      @Option(
          names = "--after",
          paramLabel = "GOAL",
          description = "The goal after which to insert them. Default: the current goal.")
      private String after;

      @Option(names = "--now", description = "Pursue them immediately, before the current goal.")
      private boolean now;
    }

    @Override
    MissionOrder order() {
      MissionOrder order = withGoals(MissionAction.INSERT, file).now(place.now);
      return place.after == null ? order : order.uid(place.after);
    }
  }

  @Command(
      name = "update",
      description = {
        "Change goals: the fields given in a mission file replace those of the goals with the "
            + "same names."
      })
  static final class Update extends OrderCommand {
    @Parameters(paramLabel = "FILE", description = "A mission file with the changed fields only.")
    private Path file;

    @Override
    MissionOrder order() {
      return withGoals(MissionAction.UPDATE, file);
    }
  }

  @Command(
      name = "pause",
      description = {
        "Pause the mission: the vehicle stops, or circles if it cannot stop. Time limits are also paused.",
        "",
        "resume continues with the same goal; goto and insert --now also end the pause."
      })
  static final class Pause extends OrderCommand {
    @Override
    MissionOrder order() {
      return new MissionOrder().action(MissionAction.PAUSE);
    }
  }

  @Command(
      name = "resume",
      description = {
        "Continue a paused mission.",
        "",
        "If it is not paused: return to the goal that goto interrupted or, with the variable "
            + "RESUME = ORDERED, at which the previous process stopped."
      })
  static final class Resume extends OrderCommand {
    @Override
    MissionOrder order() {
      return new MissionOrder().action(MissionAction.RESUME);
    }
  }

  @Command(
      name = "return",
      description = {
        "Return to home or to a rally point of the fence, whichever is nearest.",
        "",
        "resume returns to the interrupted goal."
      })
  static final class Return extends OrderCommand {
    @Override
    MissionOrder order() {
      return new MissionOrder().action(MissionAction.RETURN);
    }
  }
}
