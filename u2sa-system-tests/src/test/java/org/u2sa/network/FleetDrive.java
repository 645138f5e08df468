package org.u2sa.network;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.awaitility.core.ConditionTimeoutException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/** Rovers under way while their way to the ground suffers, and what was measured on the ground. */
final class FleetDrive implements AutoCloseable {
  private static final Duration UP_WITHIN = Duration.ofSeconds(120);
  private static final Duration OVER_WITHIN = Duration.ofSeconds(900);
  private static final Duration ANSWERED_WITHIN = Duration.ofSeconds(3);

  private final Path folder;
  private final Clock clock = new SystemClock();
  private final Clock.Waiter waiter = clock.newWaiter("fleet-drive");
  private final Fleet fleet;
  private final Map<String, Outsider> outsiders = new TreeMap<>(); // by rover
  private final Map<String, Set<String>> services = new TreeMap<>(); // by rover
  private final Map<String, Numbers> numbers = new TreeMap<>(); // by way
  private final List<String> measured = new ArrayList<>();
  private final List<String> failures = new ArrayList<>();

  /** Starts the brokers and sends the rovers on their way. */
  FleetDrive(Path repository, Path folder, FleetBroker kind, int loops) throws Exception {
    this.folder = folder;
    fleet = new Fleet(repository, folder, kind);
    try {
      for (String ground : kind.grounds()) {
        fleet.startBroker(ground);
      }
      for (String rover : Fleet.ROVERS) {
        fleet.startBroker(rover);
        fleet.drive(rover, loops);
      }
      for (String rover : Fleet.ROVERS) {
        outsiders.put(rover, new Outsider(fleet.station(), Broker.PORT, rover, clock));
      }
      outsiders.forEach(this::awaitAll);
      String last = kind.lastGround();
      numbers.put("vehicle to ground", fleet.numbers(Fleet.CUT, Fleet.CUT, last));
      numbers.put("ground to vehicle", fleet.numbers(Fleet.SLOWED, last, Fleet.SLOWED));
    } catch (Exception | AssertionError e) {
      close();
      throw e;
    }
  }

  private void awaitAll(String rover, Outsider outsider) {
    await("all services of " + rover + " answer the ground")
        .atMost(UP_WITHIN)
        .pollInterval(Duration.ofSeconds(1))
        .until(
            () -> {
              boolean all = outsider.answered().size() == Fleet.SERVICES;
              if (!all) {
                outsider.ask();
              }
              return all;
            });
    services.put(rover, new TreeSet<>(outsider.answered()));
    say(rover + " is up: " + services.get(rover));
  }

  Fleet fleet() {
    return fleet;
  }

  List<String> failures() {
    return failures;
  }

  /** Lets a fault last, mends it, and measures until the ground sees all rovers well again. */
  void suffer(String name, NetworkFlight.Fault fault, double durationS, NetworkFlight.Fault end)
      throws Exception {
    Map<String, Losses> before = losses();
    outsiders.values().forEach(Outsider::measureGap);
    fault.happen();
    pause(durationS);
    long mended = clock.micros();
    end.happen();
    well(name, mended);
    for (String rover : Fleet.ROVERS) {
      if (!fleet.isDriving(rover)) {
        failures.add(name + ": the drive of " + rover + " ended");
      }
      say(
          String.format(
              Locale.ROOT,
              "%s, %s: %.0f s, longest time without navigation on the ground %.1f s, counted %s",
              name,
              rover,
              durationS,
              outsiders.get(rover).longestGapS(),
              outsiders.get(rover).losses().minus(before.get(rover))));
    }
    if (!fleet.allBrokersRun()) {
      failures.add(name + ": a broker ended");
    }
  }

  private Map<String, Losses> losses() {
    Map<String, Losses> losses = new TreeMap<>();
    outsiders.forEach((rover, outsider) -> losses.put(rover, outsider.losses()));
    return losses;
  }

  private void well(String name, long since) {
    try {
      await(name)
          .atMost(NetworkFlight.WELL_WITHIN)
          .pollDelay(Duration.ZERO)
          .pollInterval(Duration.ofMillis(500))
          .until(this::areWell);
    } catch (ConditionTimeoutException e) {
      failures.add(name + ": " + wrong().orElse("well only now"));
    }
    say(
        String.format(
            Locale.ROOT, "%s: well after %.1f s", name, Clock.seconds(clock.micros() - since)));
  }

  private boolean areWell() throws InterruptedException {
    outsiders.values().forEach(Outsider::ask);
    long deadline = clock.micros() + ANSWERED_WITHIN.toNanos() / 1_000;
    while (wrong().isPresent() && clock.micros() < deadline) {
      pause(0.1);
    }
    pause(0.3); // in which a second answer of the same service would come
    return wrong().isEmpty();
  }

  private Optional<String> wrong() {
    return outsiders.entrySet().stream()
        .flatMap(
            each ->
                each.getValue().wrong(services.get(each.getKey())).stream()
                    .map(what -> each.getKey() + ": " + what))
        .findFirst();
  }

  /** Each number must have arrived or be counted as missed. */
  void balance() throws IOException {
    for (Map.Entry<String, Numbers> each : numbers.entrySet()) {
      each.getValue()
          .finish()
          .forEach(
              (channel, balance) -> {
                say(each.getKey() + ", " + channel + ": " + balance);
                if (!balance.isAccounted()) {
                  failures.add(each.getKey() + ", " + channel + ": " + balance);
                }
              });
    }
  }

  /** Waits until both have driven their loops, and judges the drives. */
  void finish() throws IOException {
    for (String rover : Fleet.ROVERS) {
      await(rover + " is there").atMost(OVER_WITHIN).until(() -> !fleet.isDriving(rover));
      say(rover + ": " + fleet.end(rover) + "; failsafes " + outsiders.get(rover).failsafes());
      if (!fleet.end(rover).endsWith("given up []")) { // by its own word: truth depends on the load
        failures.add(rover + " did not complete its mission: see " + folder.resolve(rover));
      }
      if (outsiders.get(rover).restarts() != 0) {
        failures.add(rover + ": services were restarted");
      }
    }
    say("links shaped by " + fleet.lan().shaping());
    failures.forEach(failure -> say("FAILED: " + failure));
    Files.write(folder.resolve("measured.txt"), measured);
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
    numbers.values().forEach(Numbers::close);
    outsiders.values().forEach(Outsider::close);
    fleet.close();
  }
}
