package org.u2sa.network;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;

/** Rovers under way while their way to the ground suffers, and what was measured on the ground. */
final class FleetDrive implements AutoCloseable {
  private static final Duration OVER_WITHIN = Duration.ofSeconds(900);

  private final Path folder;
  private final Findings findings;
  private final Clock clock;
  private final Fleet fleet;
  private final Map<String, Outsider> outsiders = new TreeMap<>(); // by rover
  private final Map<String, Set<String>> services = new TreeMap<>(); // by rover
  private final Map<String, Numbers> numbers = new TreeMap<>(); // by way

  /** Starts the brokers and sends the rovers on their way. */
  FleetDrive(Path repository, Path folder, FleetBroker kind, int loops) throws Exception {
    this.folder = folder;
    findings = new Findings(folder);
    clock = findings.clock();
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
    services.put(rover, outsider.awaitAll(Fleet.SERVICES));
    findings.say("%s is up: %s", rover, services.get(rover));
  }

  Fleet fleet() {
    return fleet;
  }

  List<String> failures() {
    return findings.failures();
  }

  /** Lets a fault last, mends it, and measures until the ground sees all rovers well again. */
  void suffer(String name, NetworkFlight.Fault fault, double durationS, NetworkFlight.Fault end)
      throws Exception {
    Map<String, Losses> before = losses();
    outsiders.values().forEach(Outsider::measureGap);
    fault.happen();
    findings.pause(durationS);
    long mended = clock.micros();
    end.happen();
    double afterS =
        findings.awaitWell(
            name, mended, () -> outsiders.values().forEach(Outsider::ask), this::wrong);
    findings.say("%s: well after %.1f s", name, afterS);
    for (String rover : Fleet.ROVERS) {
      if (!fleet.isDriving(rover)) {
        findings.fail(name + ": the drive of " + rover + " ended");
      }
      findings.say(
          "%s, %s: %.0f s, longest time without navigation on the ground %.1f s, counted %s",
          name,
          rover,
          durationS,
          outsiders.get(rover).longestGapS(),
          outsiders.get(rover).losses().minus(before.get(rover)));
    }
    if (!fleet.allBrokersRun()) {
      findings.fail(name + ": a broker ended");
    }
  }

  private Map<String, Losses> losses() {
    Map<String, Losses> losses = new TreeMap<>();
    outsiders.forEach((rover, outsider) -> losses.put(rover, outsider.losses()));
    return losses;
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
                findings.say("%s, %s: %s", each.getKey(), channel, balance);
                if (!balance.isAccounted()) {
                  findings.fail(each.getKey() + ", " + channel + ": " + balance);
                }
              });
    }
  }

  /** Waits until both have driven their loops, and judges the drives. */
  void finish() throws IOException {
    for (String rover : Fleet.ROVERS) {
      await(rover + " is there").atMost(OVER_WITHIN).until(() -> !fleet.isDriving(rover));
      findings.say(
          "%s: %s; failsafes %s", rover, fleet.end(rover), outsiders.get(rover).failsafes());
      if (!fleet.end(rover).endsWith("given up []")) { // by its own word: truth depends on the load
        findings.fail(rover + " did not complete its mission: see " + folder.resolve(rover));
      }
      if (outsiders.get(rover).restarts() != 0) {
        findings.fail(rover + ": services were restarted");
      }
    }
    findings.say("links shaped by %s", fleet.lan().shaping());
  }

  @Override
  public void close() throws IOException {
    numbers.values().forEach(Numbers::close);
    outsiders.values().forEach(Outsider::close);
    fleet.close();
    findings.close();
  }
}
