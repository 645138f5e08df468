package org.u2sa.gcs.safety;

import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.gcs.ExitCode;
import org.u2sa.gcs.remote.Question;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.EmergencyStop;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code u2sa estop}: stops everything that moves, or lifts the stop. */
@Command(
    name = "estop",
    description = {
      "Stop everything that moves, at once, until it is cleared.",
      "",
      "Every actuator goes neutral and refuses all commands, also one that starts later, until estop --clear. An aircraft "
          + "glides, its surfaces neutral and its engine idling."
    })
public final class EmergencyStopCommand implements Callable<Integer> {
  /** A Safety Manager repeats a stop each second; without one the broker has retained it. */
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
    try (RemoteLink link = remote.connect()) {
      EmergencyStop message = new EmergencyStop().operator(RemoteSystem.operator()).reason(reason);
      if (clear) {
        message.active(false).clears(newestStop(link));
      } else {
        message.active(true);
      }
      long said = link.clock().micros();
      message.timestamp(said);
      List<EmergencyStop> echo =
          link.ask(
              new Question<>(Channels.EMERGENCY_STOP, message, EmergencyStop.class)
                  .only(
                      heard ->
                          heard.active() == message.active()
                              && heard.timestamp().equals(message.timestamp()))
                  .first());
      return report(link, !echo.isEmpty(), Clock.seconds(link.clock().micros() - said));
    }
  }

  /** The time of the newest stop that anybody speaks of; now if that is later. */
  private static long newestStop(RemoteLink link) throws InterruptedException {
    AtomicLong newest = new AtomicLong(link.clock().micros());
    link.listen(
        Channels.EMERGENCY_STOP, message -> newest.accumulateAndGet(time(message), Math::max));
    long until = link.clock().micros() + Clock.micros(Math.min(LISTEN_S, link.timeoutS()));
    try (Clock.Waiter waiter = link.clock().newWaiter("stops")) {
      while (link.clock().micros() < until) {
        waiter.await(until);
      }
    }
    return newest.get();
  }

  private static long time(U2SAData message) {
    return message instanceof EmergencyStop stop && stop.active()
        ? stop.timestamp().orElse(0L)
        : 0L;
  }

  private int report(RemoteLink link, boolean confirmed, double tookS) {
    PrintWriter out = command.commandLine().getOut();
    String what = clear ? "Emergency stop cleared" : "Emergency stop";
    if (confirmed) {
      out.printf("%s: %s (the broker had it after %.0f ms)%n", link.systemId(), what, 1e3 * tookS);
    } else {
      out.printf("%s: %s was sent, but the broker did not confirm it%n", link.systemId(), what);
    }
    out.flush();
    return confirmed ? ExitCode.DONE : ExitCode.FAILED;
  }
}
