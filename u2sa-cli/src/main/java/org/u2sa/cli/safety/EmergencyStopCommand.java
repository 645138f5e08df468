package org.u2sa.cli.safety;

import java.io.PrintWriter;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.Callable;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.safety.StopConfirmation;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.EmergencyStop;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code u2sa estop}: stops everything that moves, or clears the stop. */
@Command(
    name = "estop",
    description = {
      "Stop everything that moves, at once, until it is cleared.",
      "",
      "Every actuator goes neutral and refuses all commands, also one that starts later, until estop --clear. An aircraft "
          + "glides, its surfaces neutral and its engine idling.",
      "",
      "Exit code 0: every service that heeds stops, actuators and Safety Manager, has said that it is stopped (or, with --clear, "
          + "that nothing stops it). Exit code 1: somebody has not, and the answer says who."
    })
public final class EmergencyStopCommand implements Callable<Integer> {
  /**
   * Covers the Safety Manager's repetition of stops, once a second; without one the broker retains
   * the stop.
   */
  private static final double LISTEN_S = 1.2;

  @Spec private CommandSpec command;
  @Mixin private RemoteSystem remote;

  @Option(
      names = "--reason",
      paramLabel = "TEXT",
      defaultValue = "",
      description = "Why, for the logs.")
  private String reason;

  @Option(names = "--clear", description = "Lift the emergency stop.")
  private boolean clear;

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect();
        Clock.Waiter waiter = link.clock().newWaiter("stops")) {
      EmergencyStop message = new EmergencyStop().operator(Operator.name()).reason(reason);
      return clear ? clear(link, waiter, message) : stop(link, waiter, message);
    }
  }

  /** Publishes the stop before anything else. */
  private int stop(RemoteLink link, Clock.Waiter waiter, EmergencyStop message)
      throws InterruptedException {
    String id = Operator.name() + " " + UUID.randomUUID();
    link.publish(Channels.EMERGENCY_STOP, message.active(true).stopId(id));
    StopConfirmation vehicle = StopConfirmation.listen(link, waiter);
    StopConfirmation.Outcome holds = held -> held.contains(id);
    vehicle.await(holds);
    return report(link, vehicle, holds);
  }

  /** Clears all reported stops, and no others. */
  private int clear(RemoteLink link, Clock.Waiter waiter, EmergencyStop message)
      throws InterruptedException {
    StopConfirmation vehicle = StopConfirmation.listen(link, waiter);
    link.await(() -> false, Math.min(LISTEN_S, link.timeoutS()));
    Set<String> standing = vehicle.standing();
    long said = link.clock().micros();
    message.active(false).clears(Math.max(said, vehicle.newestMicros()));
    if (!standing.isEmpty()) {
      message.lifts(List.copyOf(standing));
    }
    link.publish(Channels.EMERGENCY_STOP, message);
    StopConfirmation.Outcome free = List::isEmpty;
    vehicle.await(free);
    return report(link, vehicle, free);
  }

  private int report(RemoteLink link, StopConfirmation vehicle, StopConfirmation.Outcome wanted)
      throws InterruptedException {
    String what = clear ? "Emergency stop cleared" : "Emergency stop";
    List<String> missing = vehicle.missing(wanted);
    List<String> by = vehicle.confirmedBy(wanted);
    String confirmed = by.isEmpty() ? "" : "confirmed by " + String.join(", ", by);
    PrintWriter out = command.commandLine().getOut();
    if (missing.isEmpty()) {
      out.printf("%s: %s, %s%n", link.systemId(), what, confirmed);
    } else {
      out.printf(
          "%s: %s was sent, but NOT CONFIRMED%s%n",
          link.systemId(), what, by.isEmpty() ? "" : " by all; " + confirmed);
      missing.forEach(reason -> out.println("  " + reason));
    }
    if (!vehicle.hearsAnybody()) {
      remote.otherSystems(link).ifPresent(out::println);
    }
    return missing.isEmpty() ? ExitCode.DONE : ExitCode.FAILED;
  }
}
