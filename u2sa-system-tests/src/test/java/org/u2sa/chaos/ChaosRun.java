package org.u2sa.chaos;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.testkit.Mosquitto;

/** One flight through many faults: takes off, breaks one thing after the other, and judges. */
final class ChaosRun {
  /** Longest time until somebody says that a service is gone: lost after 4 s of silence. */
  private static final double NOTICED_WITHIN_S = 7.0;

  /** Longest time until all services run again, back-off and start of a process included. */
  private static final double WELL_WITHIN_S = 45.0;

  /** Longest time until the aircraft has gained again what height it lost. */
  private static final double SAFE_WITHIN_S = 120.0;

  private static final double UP_WITHIN_S = 300.0;
  private static final double CALM_S = 60.0;

  /** Longer than {@link Watch} takes a report for fresh: what was said before the fault is old. */
  private static final double SETTLE_S = 1.2;

  private final Path folder;
  private final Clock clock = new SystemClock();
  private final Patience patience = new Patience(clock);
  private final List<String> failures = new ArrayList<>();
  private final StringBuilder table =
      new StringBuilder("number,kind,victim,noticedS,wellS,safeS\n");
  private Vehicle vehicle;
  private Watch watch;
  private Scene scene;
  private Map<String, String> services;

  /**
   * @param folder where the vehicle's files are copied to, and what becomes of the run is left
   */
  ChaosRun(Path folder) {
    this.folder = folder;
  }

  /** What went wrong; empty if nothing did. */
  List<String> failures() {
    return failures;
  }

  /** Flies. */
  @SuppressWarnings("try") // the judge is there to be closed
  void fly(Path repository, long seed, int faults, List<Fault.Kind> kinds) throws Exception {
    Random random = new Random(seed);
    Vehicle.copyFiles(repository, folder);
    try (Mosquitto broker = Mosquitto.withLongQueues(folder);
        TcpProxy network = new TcpProxy(broker.port());
        Watch outsider = new Watch(broker.port(), clock);
        Vehicle flown = new Vehicle(folder, network.port(), Wind.gusty(1.0, 4.0, seed));
        Probe probe = new Probe(network.port(), clock);
        FlightJudge judge = new FlightJudge(flown, clock)) {
      vehicle = flown;
      watch = outsider;
      services = Map.of();
      scene = new Scene(flown, broker, network, services, folder, clock);
      takeOff(judge);
      scene = new Scene(flown, broker, network, services, folder, clock);
      for (int number = 1; number <= faults; number++) {
        suffer(Fault.draw(number, kinds, random), judge);
      }
      end(judge, probe);
    }
  }

  private void takeOff(FlightJudge judge) throws InterruptedException {
    if (!patience.await(UP_WITHIN_S, judge::isAirborne)) {
      throw new IllegalStateException("the aircraft did not take off: see " + folder);
    }
    services = new TreeMap<>();
    for (String process : vehicle.processes().keySet()) {
      String name = serviceName(process);
      services.put(process, name);
    }
    allWell(WELL_WITHIN_S).ifPresent(wrong -> failures.add("before the first fault: " + wrong));
  }

  /** The service that a process runs: its class's name, or the one that its configuration gives. */
  private String serviceName(String simpleName) {
    return watch.services().stream()
        .filter(simpleName::endsWith) // PassThroughStateEstimator is StateEstimator
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalStateException(
                    "no health of " + simpleName + " among " + watch.services()));
  }

  private void suffer(Fault fault, FlightJudge judge) throws Exception {
    String victim = services.get(scene.victim(fault));
    String instance = watch.instance(victim);
    long began = clock.micros();
    say(fault + " at " + victim);
    Noticing noticing = new Noticing(watch, patience, victim, instance, began, WELL_WITHIN_S);
    if (fault.kind().endsService()) {
      noticing.start();
    }
    scene.happen(fault);
    scene.pause(SETTLE_S);
    Optional<String> wrong = allWell(WELL_WITHIN_S);
    double wellS = Clock.seconds(clock.micros() - began);
    wrong.ifPresent(what -> failures.add(fault + ": " + what + " after " + (int) wellS + " s"));
    String noticed = "";
    if (fault.kind().endsService()) {
      Optional<Double> afterS = noticing.afterS();
      noticed = afterS.map(s -> String.format(Locale.ROOT, "%.2f", s)).orElse("never");
      if (afterS.isEmpty() || afterS.get() > NOTICED_WITHIN_S) {
        failures.add(fault + ": that " + victim + " is gone was noticed " + noticed);
      }
    }
    if (!patience.await(SAFE_WITHIN_S, judge::isSafe)) {
      failures.add(fault + ": the aircraft did not come back to a safe height");
    }
    double safeS = Clock.seconds(clock.micros() - began);
    if (!vehicle.isSupervised()) {
      throw new IllegalStateException("the supervisor ended: see " + folder);
    }
    table.append(
        String.format(
            Locale.ROOT,
            "%d,%s,%s,%s,%.2f,%.2f%n",
            fault.number(),
            fault.kind(),
            victim,
            noticed,
            wellS,
            safeS));
    write("faults.csv", table.toString());
    scene.pause(fault.pauseS());
  }

  private void end(FlightJudge judge, Probe probe) throws InterruptedException, IOException {
    scene.pause(CALM_S);
    long goals = goalsReached();
    if (goals == 0) {
      failures.add("no goal was completed");
    }
    allWell(WELL_WITHIN_S).ifPresent(wrong -> failures.add("at the end: " + wrong));
    judge.violations().forEach(what -> failures.add("the aircraft " + what));
    probe.finish();
    if (probe.received() + probe.missed() != probe.sent()) {
      failures.add(
          probe.sent()
              + " probes sent, "
              + probe.received()
              + " received, but "
              + probe.missed()
              + " known to be missed");
    }
    write("track.csv", judge.track());
    StringBuilder summary = new StringBuilder();
    summary.append(judge.extremes()).append('\n');
    summary.append("probes: ").append(probe.sent()).append(" sent, ").append(probe.received());
    summary.append(" received, ").append(probe.missed()).append(" counted as missed\n");
    summary.append("failsafes told: ").append(watch.failsafes()).append('\n');
    summary.append("goals completed: ").append(goals).append('\n');
    services.values().forEach(name -> summary.append(counts(name)).append('\n'));
    failures.forEach(failure -> summary.append("FAILED: ").append(failure).append('\n'));
    write("summary.txt", summary.toString());
    say(summary.toString());
  }

  /** Lines of the log that say so: it is flushed line by line, whatever kills its writer. */
  private long goalsReached() throws IOException {
    try (var lines = Files.lines(folder.resolve("logs/MissionManager.log"))) {
      return lines.filter(line -> line.endsWith("completed")).count();
    }
  }

  private String counts(String name) {
    return name
        + ": "
        + watch
            .report(name)
            .map(
                (HealthReport report) ->
                    "dropped "
                        + report.dropped()
                        + ", refused "
                        + report.refused()
                        + ", missed "
                        + report.missed().orElse(0)
                        + ", exceptions "
                        + report.exceptions())
            .orElse("no report");
  }

  /** Waits until every service runs exactly once; otherwise what is wrong. */
  private Optional<String> allWell(double withinS) throws InterruptedException {
    return patience.await(withinS, () -> wrong().isEmpty()) ? Optional.empty() : wrong();
  }

  private Optional<String> wrong() {
    return services.values().stream().flatMap(name -> watch.wrongWith(name).stream()).findFirst();
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private void say(String line) {
    System.out.printf(Locale.ROOT, "%8.1f s  %s%n", vehicle.truth().get(OutField.ELAPSED), line);
  }
}
