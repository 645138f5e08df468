package org.u2sa.chaos;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.testkit.Mosquitto;
import org.u2sa.testkit.Repository;

/**
 * Each service of the Cessna is killed once in flight, kill −9, where each is a process of its own:
 * the vehicle flies on and reaches every waypoint once, in order. Five minutes; needs Mosquitto.
 * Writes what it measured to standard output.
 */
@Tag("chaos")
class EachServiceKilledTest {
  private static final int WAYPOINTS = 2;
  private static final Duration FLIGHT = Duration.ofMinutes(10);
  private static final Duration BACK = Duration.ofSeconds(45);
  private static final Pattern REACHED = Pattern.compile("goal \"(\\d+)\" completed");

  @TempDir private Path folder;
  private final Clock clock = new SystemClock();

  @Test
  void kill_eachServiceOnce_missionIsCompleted() throws Exception {
    Vehicle.copyFiles(Repository.root(), folder);
    shortenMission(folder.resolve("missions/cessna/mission.xml"));
    try (Mosquitto broker = Mosquitto.withLongQueues(folder);
        Watch watch = new Watch(broker.port(), clock);
        Gaps gaps = new Gaps(broker.port(), clock);
        Vehicle vehicle = new Vehicle(folder, broker.port(), Wind.gusty(1.0, 4.0, 1));
        FlightJudge judge = new FlightJudge(vehicle, clock)) {
      soon(FLIGHT, judge::isAirborne);
      Map<String, String> services = new TreeMap<>(); // by class
      vehicle.processes().keySet().forEach(name -> services.put(name, serviceName(name, watch)));
      assertThat(services).hasSize(7);

      for (Map.Entry<String, String> each : services.entrySet()) {
        kill(each.getKey(), each.getValue(), vehicle, watch, gaps);
      }
      soon(FLIGHT, () -> reached().size() >= WAYPOINTS);

      assertThat(reached().subList(0, WAYPOINTS)).containsExactly("1", "2");
      assertThat(judge.violations()).isEmpty();
      System.out.println(judge.extremes());
    }
  }

  private void kill(String process, String service, Vehicle vehicle, Watch watch, Gaps gaps)
      throws InterruptedException {
    String before = watch.instance(service);
    gaps.forget();
    long began = clock.micros();
    Signal.KILL.send(vehicle.processes().get(process));
    soon(BACK, () -> !watch.instance(service).equals(before) && watch.wrongWith(service).isEmpty());
    double backS = sinceS(began);
    Optional<Watch.Told> told = watch.firstTrouble(service, began);
    calm(watch, 4.0);
    System.out.printf(
        Locale.ROOT,
        "%-16s told after %s s, back after %.1f s; longest gap of states %.1f s, navigation %.1f s, commands %.1f s%n",
        service,
        told.map(word -> String.format(Locale.ROOT, "%.2f", Clock.seconds(word.atMicros() - began)))
            .orElse("-"),
        backS,
        gaps.longestS(Channels.STATE),
        gaps.longestS(Channels.NAVIGATION),
        gaps.longestS(Channels.ACTUATION));
  }

  /** Lets the vehicle fly until all services have been well for a while. */
  private void calm(Watch watch, double forS) {
    long[] wellSince = {clock.micros()};
    soon(
        BACK,
        () -> {
          boolean well = watch.services().stream().allMatch(s -> isWell(watch, s));
          wellSince[0] = well ? wellSince[0] : clock.micros();
          return sinceS(wellSince[0]) > forS;
        });
  }

  private static boolean isWell(Watch watch, String service) {
    return service.startsWith("Launcher") || watch.wrongWith(service).isEmpty();
  }

  private double sinceS(long micros) {
    return Clock.seconds(clock.micros() - micros);
  }

  private static void soon(Duration within, BooleanSupplier condition) {
    await().atMost(within).until(condition::getAsBoolean);
  }

  /** By the log: it is flushed line by line, whatever is killed. */
  private List<String> reached() {
    try (Stream<String> lines = Files.lines(folder.resolve("logs/MissionManager.log"))) {
      return lines
          .map(REACHED::matcher)
          .filter(Matcher::find)
          .map(found -> found.group(1))
          .toList();
    } catch (IOException e) {
      return List.of(); // not yet
    }
  }

  /** The service that a process runs: its class's name, or the one that its configuration gives. */
  private static String serviceName(String simpleName, Watch watch) {
    return watch.services().stream().filter(simpleName::endsWith).findFirst().orElseThrow();
  }

  private static void shortenMission(Path file) throws IOException {
    String all = Files.readString(file);
    int third = all.indexOf("<name>3</name>");
    String first = all.substring(0, all.lastIndexOf("<waypoint>", third));
    Files.writeString(file, first.replace("<next>3</next>", "") + "</mission>\n");
  }
}
