package org.u2sa.network;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.awaitility.core.ConditionTimeoutException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.FailsafeAction;

/** One flight over three hosts, during which the network suffers, and what was measured. */
final class NetworkFlight implements AutoCloseable {
  private static final Duration UP_WITHIN = Duration.ofSeconds(120);
  private static final Duration ALOFT_WITHIN = Duration.ofSeconds(240);
  private static final Duration LANDED_WITHIN = Duration.ofSeconds(900);
  private static final double ALOFT_M = 330.0;

  /** Also over a slow link and on a busy machine. */
  private static final Duration ANSWERED_WITHIN = Duration.ofSeconds(3);

  /** In which a second answer of the same service would come. */
  private static final double SETTLED_S = 0.2;

  /** From the end of a fault; two back-offs, a look for who is there, and a busy machine. */
  static final Duration WELL_WITHIN = Duration.ofSeconds(25);

  /** Something done to the network. */
  interface Fault {
    void happen() throws Exception;
  }

  private final Path folder;
  private final Clock clock = new SystemClock();
  private final Clock.Waiter waiter = clock.newWaiter("network-flight");
  private final ThreeHosts hosts;
  private final Outsider outsider;
  private final Set<String> services;
  private final Numbers numbers;
  private final List<String> measured = new ArrayList<>();
  private final List<String> failures = new ArrayList<>();

  /** Starts the hosts in the order that is least convenient: the broker comes last. */
  NetworkFlight(Path repository, Path folder, Broker broker) throws Exception {
    this.folder = folder;
    hosts = new ThreeHosts(repository, folder, broker);
    try {
      hosts.start(ThreeHosts.PILOT);
      hosts.start(ThreeHosts.AIRCRAFT);
      hosts.start(ThreeHosts.HUB);
      hosts.startBroker();
      outsider =
          new Outsider(hosts.lan().address(ThreeHosts.HUB), Broker.PORT, ThreeHosts.SYSTEM, clock);
      await("all services of the system file answer")
          .atMost(UP_WITHIN)
          .pollInterval(Duration.ofSeconds(1))
          .until(this::allAnswer);
      services = new TreeSet<>(outsider.answered());
      say("up: " + services);
      numbers = hosts.numbersFrom(ThreeHosts.PILOT);
    } catch (Exception | AssertionError e) {
      hosts.close();
      throw e;
    }
  }

  private boolean allAnswer() {
    boolean all = outsider.answered().size() == hosts.size();
    if (!all) {
      outsider.ask();
    }
    return all;
  }

  ThreeHosts hosts() {
    return hosts;
  }

  /** Waits until the aircraft is high enough to glide for a while. */
  void climb() {
    await("the aircraft is aloft")
        .atMost(ALOFT_WITHIN)
        .until(() -> hosts.aircraft().heightM() > ALOFT_M);
  }

  /**
   * Lets a fault last, mends it, and measures until all is well again.
   *
   * @param cutOff services whose connections must be said to be lost meanwhile
   */
  void suffer(String name, Fault fault, double durationS, Fault end, Set<String> cutOff)
      throws Exception {
    climb();
    Losses before = outsider.losses();
    long restarts = outsider.restarts();
    outsider.measureGap();
    long began = clock.micros();
    fault.happen();
    pause(durationS);
    for (String service : cutOff) {
      if (outsider.will(service, began).isEmpty()) {
        failures.add(name + ": nobody said that " + service + " is gone");
      }
    }
    long mended = clock.micros();
    end.happen();
    String after = well(name, mended);
    say(
        String.format(
            Locale.ROOT,
            "%s: %.0f s, well after %s s, longest time without navigation %.1f s, counted %s, %d restarts",
            name,
            durationS,
            after,
            outsider.longestGapS(),
            outsider.losses().minus(before),
            outsider.restarts() - restarts));
    if (!hosts.allRun()) {
      failures.add(name + ": a process ended");
    }
  }

  /** Waits until the directory shows every service once, and says when it did. */
  private String well(String name, long since) {
    try {
      await(name)
          .atMost(WELL_WITHIN)
          .pollDelay(Duration.ZERO)
          .pollInterval(Duration.ofMillis(500))
          .until(this::isWell);
    } catch (ConditionTimeoutException e) {
      failures.add(name + ": " + wrong().orElse("well only now"));
    }
    return String.format(Locale.ROOT, "%.1f", Clock.seconds(clock.micros() - since));
  }

  private boolean isWell() throws InterruptedException {
    outsider.ask();
    long deadline = clock.micros() + ANSWERED_WITHIN.toNanos() / 1_000;
    while (!outsider.answered().containsAll(services) && clock.micros() < deadline) {
      pause(SETTLED_S / 4);
    }
    pause(SETTLED_S);
    return wrong().isEmpty();
  }

  private Optional<String> wrong() {
    return outsider.wrong(services);
  }

  /** A host whose services are gone for good: all others must know it, and nobody may be left. */
  void vanishForGood(String host, Set<String> gone, String launcher) throws Exception {
    long began = clock.micros();
    hosts.lan().cut(host);
    hosts.kill(host);
    try {
      await("all know that " + gone + " are lost")
          .atMost(WELL_WITHIN)
          .until(() -> gone.stream().allMatch(outsider::isTakenForLost));
    } catch (ConditionTimeoutException e) {
      failures.add(host + " vanished: not everybody knows");
    }
    say(host + " gone for good: known after " + Clock.seconds(clock.micros() - began) + " s");
    services.removeAll(gone);
    services.remove(launcher);
    well(host + " vanished", clock.micros());
  }

  /** Each number sent from the pilot's host must have arrived once or be counted as missed. */
  void balance() throws IOException {
    numbers
        .finish()
        .forEach(
            (channel, balance) -> {
              say(channel + ": " + balance);
              if (!balance.isEven()) {
                failures.add(channel + ": " + balance);
              }
            });
  }

  List<String> failures() {
    return failures;
  }

  /**
   * Waits for the mission's end, and says what went wrong in the whole flight.
   *
   * @param startedAnew services that were killed once and started anew; no other may have been
   */
  void land(Set<String> startedAnew) throws IOException {
    try {
      await("the mission is over").atMost(LANDED_WITHIN).until(outsider::isMissionOver);
    } catch (ConditionTimeoutException e) {
      failures.add("the mission was not completed");
    }
    if (!hosts.log(ThreeHosts.HUB, "MissionManager").contains("completed [1, 2, 3], given up []")) {
      failures.add("goals were given up");
    }
    well("at the end", clock.micros());
    failures.addAll(outsider.wrongInstances(startedAnew));
    settle();
    hosts.aircraft().violations().forEach(what -> failures.add("the aircraft " + what));
    say(hosts.aircraft().extremes() + "; failsafes " + outsider.failsafes());
    say("links shaped by " + hosts.lan().shaping());
    failures.forEach(failure -> say("FAILED: " + failure));
    Files.writeString(folder.resolve("track.csv"), hosts.aircraft().track());
    Files.write(folder.resolve("measured.txt"), measured);
  }

  /** The configured failsafe must have acted when states were missing, and be over. */
  private void settle() {
    try {
      await("the failsafe is over")
          .atMost(WELL_WITHIN)
          .until(() -> outsider.failsafe().equals(FailsafeAction.CONTINUE.name()));
    } catch (ConditionTimeoutException e) {
      failures.add("the failsafe is still " + outsider.failsafe());
    }
    if (!outsider.failsafes().contains(FailsafeAction.HOLD.name())) {
      failures.add("no failsafe acted: " + outsider.failsafes());
    }
  }

  private void pause(double seconds) throws InterruptedException {
    long until = clock.micros() + Clock.micros(seconds);
    while (clock.micros() < until) {
      waiter.await(until);
    }
  }

  private void say(String line) {
    measured.add(line);
    System.out.println(line);
  }

  @Override
  public void close() throws IOException {
    waiter.close();
    numbers.close();
    outsider.close();
    hosts.close();
  }
}
