package org.u2sa.cli.mission;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.UUID;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;

/** Sends an order to the Mission Manager and prints the result. */
final class OrderToMissionManager {
  private OrderToMissionManager() {}

  /**
   * Creates an order with goals.
   *
   * @param file a mission file with goals only; parsed by the Mission Manager, which knows the goal
   *     classes
   * @throws BadInputException if it is not a mission file
   */
  static MissionOrder withGoals(MissionAction action, Path file) {
    XmlReader.read(file, "mission");
    try {
      return new MissionOrder().action(action).goals(Files.readString(file)).file(file.toString());
    } catch (CharacterCodingException e) {
      throw new BadInputException(file + ": is not in UTF-8, in which orders are sent", e);
    } catch (IOException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
  }

  /**
   * Sends the order and waits for its result.
   *
   * @param order without request ID and operator
   * @throws RunFailedException if it was rejected or not answered in time
   */
  static int give(RemoteSystem remote, MissionOrder order, PrintWriter out)
      throws InterruptedException {
    String id = UUID.randomUUID().toString();
    try (RemoteLink link = remote.connect()) {
      MissionOrder asked = order.requestId(id).operator(Operator.name());
      MissionOrderResult result =
          link.first(
                  Channels.MISSION,
                  asked,
                  MissionOrderResult.class,
                  each -> each.requestId().equals(id))
              .orElse(null);
      if (result == null) {
        throw nobody(remote, link);
      }
      if (!result.accepted()) {
        throw new RunFailedException(order.action() + " was not done: " + result.outcome());
      }
      out.println(link.systemId() + ": " + result.outcome());
      return ExitCode.DONE;
    }
  }

  /** Message for a missing answer. */
  static RunFailedException nobody(RemoteSystem remote, RemoteLink link)
      throws InterruptedException {
    return new RunFailedException(
        link.systemId()
            + ": no Mission Manager answered within "
            + link.timeoutS()
            + " s; ./u2sa services shows whether one runs"
            + remote.otherSystems(link).map(others -> ";" + others.substring(1)).orElse(""));
  }
}
