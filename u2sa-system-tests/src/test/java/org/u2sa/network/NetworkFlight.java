package org.u2sa.network;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.awaitility.core.ConditionTimeoutException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.FailsafeAction;

/** One flight over three hosts, during which the network suffers, and what was measured. */
final class NetworkFlight implements AutoCloseable {
  private static final Duration ALOFT_WITHIN = Duration.ofSeconds(240);
  private static final Duration LANDED_WITHIN = Duration.ofSeconds(900);
  private static final double ALOFT_M = 330.0;

  /** Something done to the network. */
  interface Fault {
    void happen() throws Exception;
  }

  private final Path folder;
  private final Findings findings;
  private final Clock clock;
  private final ThreeHosts hosts;
  private final Outsider outsider;
  private final Set<String> services;
  private final Numbers numbers;

  /** Starts the hosts in the order that is least convenient: the broker comes last. */
  NetworkFlight(Path repository, Path folder, Broker broker) throws Exception {
    this.folder = folder;
    findings = new Findings(folder);
    clock = findings.clock();
    hosts = new ThreeHosts(repository, folder, broker);
    try {
      hosts.start(ThreeHosts.PILOT);
      hosts.start(ThreeHosts.AIRCRAFT);
      hosts.start(ThreeHosts.HUB);
      hosts.startBroker();
      outsider =
          new Outsider(hosts.lan().address(ThreeHosts.HUB), Broker.PORT, ThreeHosts.SYSTEM, clock);
      services = outsider.awaitAll(hosts.size());
      findings.say("up: %s", services);
      numbers = hosts.numbersFrom(ThreeHosts.PILOT);
    } catch (Exception | AssertionError e) {
      hosts.close();
      throw e;
    }
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
    findings.pause(durationS);
    for (String service : cutOff) {
      if (outsider.will(service, began).isEmpty()) {
        findings.fail(name + ": nobody said that " + service + " is gone");
      }
    }
    long mended = clock.micros();
    end.happen();
    double afterS = well(name, mended);
    findings.say(
        "%s: %.0f s, well after %.1f s, longest time without navigation %.1f s, counted %s, %d restarts",
        name,
        durationS,
        afterS,
        outsider.longestGapS(),
        outsider.losses().minus(before),
        outsider.restarts() - restarts);
    if (!hosts.allRun()) {
      findings.fail(name + ": a process ended");
    }
  }

  /** Waits until the directory shows every service once, and says how long that took [s]. */
  private double well(String name, long since) {
    return findings.awaitWell(name, since, outsider::ask, () -> outsider.wrong(services));
  }

  /** A host whose services are gone for good: all others must know it, and nobody may be left. */
  void vanishForGood(String host, Set<String> gone, String launcher) throws Exception {
    long began = clock.micros();
    hosts.lan().cut(host);
    hosts.kill(host);
    try {
      await("all know that " + gone + " are lost")
          .atMost(Findings.WELL_WITHIN)
          .until(() -> gone.stream().allMatch(outsider::isTakenForLost));
    } catch (ConditionTimeoutException e) {
      findings.fail(host + " vanished: not everybody knows");
    }
    findings.say(
        "%s gone for good: known after %.1f s", host, Clock.seconds(clock.micros() - began));
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
              findings.say("%s: %s", channel, balance);
              if (!balance.isEven()) {
                findings.fail(channel + ": " + balance);
              }
            });
  }

  List<String> failures() {
    return findings.failures();
  }

  /**
   * Waits for the mission's end, and says what went wrong in the whole flight.
   *
   * @param startedAnew services that were killed once and started again; no other may have been
   */
  void land(Set<String> startedAnew) throws IOException {
    try {
      await("the mission is over").atMost(LANDED_WITHIN).until(outsider::isMissionOver);
    } catch (ConditionTimeoutException e) {
      findings.fail("the mission was not completed");
    }
    if (!hosts.log(ThreeHosts.HUB, "MissionManager").contains("completed [1, 2, 3], given up []")) {
      findings.fail("goals were given up");
    }
    well("at the end", clock.micros());
    outsider.wrongInstances(startedAnew).forEach(findings::fail);
    settle();
    hosts.aircraft().violations().forEach(what -> findings.fail("the aircraft " + what));
    findings.say("%s; failsafes %s", hosts.aircraft().extremes(), outsider.failsafes());
    findings.say("links shaped by %s", hosts.lan().shaping());
    Files.writeString(folder.resolve("track.csv"), hosts.aircraft().track());
  }

  /** The configured failsafe must have acted when states were missing, and be over. */
  private void settle() {
    try {
      await("the failsafe is over")
          .atMost(Findings.WELL_WITHIN)
          .until(() -> outsider.failsafe().equals(FailsafeAction.CONTINUE.name()));
    } catch (ConditionTimeoutException e) {
      findings.fail("the failsafe is still " + outsider.failsafe());
    }
    if (!outsider.failsafes().contains(FailsafeAction.HOLD.name())) {
      findings.fail("no failsafe acted: " + outsider.failsafes());
    }
  }

  @Override
  public void close() throws IOException {
    numbers.close();
    outsider.close();
    hosts.close();
    findings.close();
  }
}
