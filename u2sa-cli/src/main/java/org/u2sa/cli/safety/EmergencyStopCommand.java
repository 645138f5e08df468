package org.u2sa.cli.safety;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.Unanswered;
import org.u2sa.gcs.safety.StopConfirmation;
import org.u2sa.gcs.safety.StopOrder;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.mqtt.failure.ConnectFailure;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.safety.EmergencyStop;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa estop}: stops everything that moves, or clears the stop. */
@Command(
    name = "estop",
    description = {
      "Stop everything that moves, immediately, until the stop is cleared.",
      "",
      "Every actuator, including those started later, goes neutral and refuses all commands until estop --clear. An aircraft "
          + "glides, its surfaces neutral and its engine idling.",
      "",
      "Without --system the stop is sent to every system at the broker that the user may "
          + "command, as soon as each is discovered; "
          + "without --broker, to the brokers of all systems that this account runs on this "
          + "machine. --clear clears the stops of one system; choose it with --system if several "
          + "are found.",
      "",
      "Exit code 0: all actuators and Safety Managers have confirmed that they are stopped (or, "
          + "with --clear, "
          + "that no stop remains). Exit code 1: the output names those that have not."
    })
public final class EmergencyStopCommand extends BaseCommand {
  /**
   * Covers the Safety Manager's stop repetition interval of one second; without a Safety Manager,
   * the broker retains the stop.
   */
  private static final double LISTEN_S = 1.2;

  private static final double CONNECTS_WITHIN_S = 20.0; // to a broker that is there
  private static final double PAUSE_S = 0.3; // between attempts, which are part of the flood
  private static final int LIFTS_BYTES = 12_000; // in a message of 16 KiB at most
  private static final int MAX_LINES = 30; // an attacker can announce thousands of services

  @Mixin private RemoteSystem remote;

  @Option(
      names = "--reason",
      paramLabel = "TEXT",
      defaultValue = "",
      description = "Reason, for the logs.")
  private String reason;

  @Option(names = "--clear", description = "Clear the emergency stop.")
  private boolean clear;

  @Override
  public Integer call() throws InterruptedException {
    return clear ? clear() : stop();
  }

  /**
   * Publishes the stop first, and to all brokers in parallel, so that an unresponsive broker does
   * not delay the others.
   */
  private int stop() throws InterruptedException {
    List<RemoteSystem> brokers = remote.atEachBroker();
    if (brokers.size() == 1) {
      return stop(brokers.get(0));
    }
    ExecutorService threads = Executors.newFixedThreadPool(brokers.size());
    try {
      List<Future<Integer>> codes =
          brokers.stream().map(each -> threads.submit(() -> stop(each))).toList();
      int worst = ExitCode.DONE;
      for (int i = 0; i < brokers.size(); i++) {
        worst = Math.max(worst, code(brokers.get(i), codes.get(i)));
      }
      return worst;
    } finally {
      threads.shutdownNow();
    }
  }

  private int code(RemoteSystem at, Future<Integer> code) throws InterruptedException {
    try {
      return code.get();
    } catch (ExecutionException e) {
      out().printf("%s: NOT STOPPED: %s%n", at.brokerAddress(), e.getCause().getMessage());
      return ExitCode.FAILED;
    }
  }

  private int stop(RemoteSystem at) throws InterruptedException {
    try (RemoteLink link = connect(at);
        Clock.Waiter waiter = link.clock().newWaiter("stops")) {
      StopOrder order = new StopOrder(link, waiter, Operator.name(), reason);
      at.known().forEach(order::send);
      if (!at.isChosen()) {
        order.sendToAllHeard();
      }
      SortedMap<String, StopConfirmation> vehicles = order.await();
      if (vehicles.isEmpty()) {
        throw at.nobodyHeard();
      }
      int worst = ExitCode.DONE;
      for (String system : vehicles.keySet()) {
        String failure = order.failure(system);
        int code =
            failure.isEmpty()
                ? report(at, link, system, vehicles.get(system), order.holds())
                : notSent(system, failure);
        worst = Math.max(worst, code);
      }
      if (order.leftSome()) {
        out()
            .printf(
                "More than %d systems were found; those not listed were NOT STOPPED: --system "
                    + "chooses one%n",
                StopOrder.MAX_SYSTEMS);
        worst = Math.max(worst, ExitCode.FAILED);
      }
      return worst;
    }
  }

  /** Connects, again and again if the broker is there but too busy to answer. */
  private static RemoteLink connect(RemoteSystem at) throws InterruptedException {
    Clock clock = new SystemClock();
    long until = clock.micros() + Clock.micros(CONNECTS_WITHIN_S);
    try (Clock.Waiter pause = clock.newWaiter("estop")) {
      while (true) {
        try {
          return at.connectToAll();
        } catch (CommunicationException e) {
          if (clock.micros() > until || !ConnectFailure.isPassing(e)) {
            throw e;
          }
          at.tell("the broker at " + at.brokerAddress() + " does not answer yet: trying again");
          pause.await(clock.micros() + Clock.micros(PAUSE_S));
        }
      }
    }
  }

  private int notSent(String system, String failure) {
    out().printf("%s: Emergency stop was NOT SENT: %s%n", system, failure);
    return ExitCode.FAILED;
  }

  /** Clears all reported stops only. */
  private int clear() throws InterruptedException {
    try (RemoteLink link = remote.connectForOrders();
        Clock.Waiter waiter = link.clock().newWaiter("stops")) {
      return clear(link, waiter);
    }
  }

  private int clear(RemoteLink link, Clock.Waiter waiter) throws InterruptedException {
    StopConfirmation vehicle = StopConfirmation.listen(link, link.systemId(), waiter);
    link.await(() -> false, Math.min(LISTEN_S, link.timeoutS()));
    Set<String> standing = vehicle.standing();
    if (standing.isEmpty()) { // a time would clear a stop that is given just now
      link.publish(Channels.EMERGENCY_STOP, clearing());
    }
    for (List<String> lifted : parts(standing)) {
      long clears = Math.max(link.clock().micros(), vehicle.newestMicros());
      link.publish(Channels.EMERGENCY_STOP, clearing().clears(clears).lifts(lifted));
    }
    StopConfirmation.Outcome free = List::isEmpty;
    vehicle.await(free);
    return report(remote, link, link.systemId(), vehicle, free);
  }

  private EmergencyStop clearing() {
    return new EmergencyStop().active(false).operator(Operator.name()).reason(reason);
  }

  /** Stops in lists that each fit into a message. */
  static List<List<String>> parts(Collection<String> stops) {
    List<List<String>> parts = new ArrayList<>();
    int left = 0;
    for (String stop : stops) {
      int bytes = stop.getBytes(StandardCharsets.UTF_8).length;
      if (parts.isEmpty() || bytes > left) {
        parts.add(new ArrayList<>());
        left = LIFTS_BYTES;
      }
      parts.get(parts.size() - 1).add(stop);
      left -= bytes;
    }
    return parts;
  }

  private int report(
      RemoteSystem at,
      RemoteLink link,
      String system,
      StopConfirmation vehicle,
      StopConfirmation.Outcome wanted)
      throws InterruptedException {
    String what = clear ? "Emergency stop cleared" : "Emergency stop";
    List<String> missing = vehicle.missing(wanted);
    List<String> by = vehicle.confirmedBy(wanted);
    String confirmed = by.isEmpty() ? "" : "confirmed by " + String.join(", ", shortened(by));
    StringBuilder text = new StringBuilder();
    if (missing.isEmpty()) {
      text.append(String.format("%s: %s, %s%n", system, what, confirmed));
    } else {
      text.append(
          String.format(
              "%s: %s was sent, but NOT CONFIRMED%s%n",
              system, what, by.isEmpty() ? "" : " by all; " + confirmed));
      shortened(missing).forEach(reason -> text.append(String.format("  %s%n", reason)));
      String later = clear ? Unanswered.EXPIRING : Unanswered.LASTING;
      text.append(String.format("  %s%n", later));
    }
    out().print(text); // in one write: reports from several brokers must not mix
    out().flush();
    if (!vehicle.hearsAnybody()) {
      at.otherSystems(link).ifPresent(out()::println);
    } else if (!missing.isEmpty()) {
      at.explainRefusal();
    }
    return missing.isEmpty() ? ExitCode.DONE : ExitCode.FAILED;
  }

  private static List<String> shortened(List<String> lines) {
    if (lines.size() <= MAX_LINES) {
      return lines;
    }
    List<String> shortened = new ArrayList<>(lines.subList(0, MAX_LINES));
    shortened.add("and " + (lines.size() - MAX_LINES) + " more");
    return shortened;
  }
}
