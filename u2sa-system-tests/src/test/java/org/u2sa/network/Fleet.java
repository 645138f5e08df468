package org.u2sa.network;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.u2sa.cli.Main;

/**
 * Ground vehicles and a ground station, each a host of its own with a broker of its own, by the
 * files of {@code config/fleet} as they are, but for the hosts' names.
 */
final class Fleet implements AutoCloseable {
  static final String CUT = "rover1";
  static final String SLOWED = "rover2";
  static final List<String> ROVERS = List.of(CUT, SLOWED);

  /** Services of config/ugv/system.xml, their launcher, and the observer of the truth. */
  static final int SERVICES = 11;

  private static final String OVER = "mission is over";

  private final Path repository;
  private final Path folder;
  private final FleetBroker kind;
  private final Lan lan;
  private final Map<String, Process> brokers = new LinkedHashMap<>(); // by host
  private final Map<String, Process> drives = new TreeMap<>(); // by rover

  /** Makes the hosts; nothing runs yet. */
  Fleet(Path repository, Path folder, FleetBroker kind) throws IOException, InterruptedException {
    this.repository = repository;
    this.folder = folder;
    this.kind = kind;
    List<String> hosts = new ArrayList<>(kind.grounds());
    hosts.addAll(ROVERS);
    lan = new Lan(repository, folder, hosts.toArray(String[]::new));
  }

  Lan lan() {
    return lan;
  }

  /** Address at which the ground listens to its vehicles. */
  String station() {
    return lan.address(kind.lastGround());
  }

  /** Starts the broker of a host, with what it stored before, if it ran before. */
  void startBroker(String host) throws IOException {
    Path own = Files.createDirectories(folder.resolve(host));
    String text =
        Files.readString(repository.resolve("config/fleet").resolve(kind.configuration(host)));
    if (!kind.grounds().contains(host)) {
      // so that the test, which is no program of the vehicle's, can look from there, too
      text = text.replace(CUT, host).replaceAll("(127\\.0\\.0\\.1)(\\s+port: 1883)", "0.0.0.0$2");
      text = text.replace("listener 1883 127.0.0.1", "listener 1883");
      text =
          text.replaceFirst(
              "(topic u2sa/.*/)arming(/# in 1)\\n", "$0$1numbers-every$2\n$1numbers-latest$2\n");
    }
    for (String ground : kind.grounds()) {
      text = text.replace(ground, lan.address(ground));
    }
    Path file = own.resolve("broker.conf");
    Files.writeString(file, text);
    brokers.put(host, start(host, "broker", kind.program(host, file, own.resolve("store"))));
  }

  /** kill −9. */
  void killBroker(String host) throws InterruptedException {
    brokers.get(host).destroyForcibly().waitFor();
  }

  /** Sends a rover on its way, whose system ID is the host's name. */
  void drive(String rover, int loops) throws IOException {
    Path home = folder.resolve(rover);
    copy("config/ugv", home);
    copy("missions/ugv", home);
    Path system = home.resolve("config/ugv/system.xml");
    Files.writeString(
        system,
        Files.readString(system).replace("<system id=\"ugv\"", "<system id=\"" + rover + '"'));
    List<String> command = ThreeHosts.java(Main.class, "demo", "ugv", "--realtime");
    command.add(1, "-Du2sa.home=" + home);
    command.addAll(List.of("--loops", "" + loops, "--out", home.resolve("out").toString()));
    command.addAll(List.of("--port", "" + Broker.PORT));
    command.addAll(List.of("--set", "CommunicationManager:BROKER=external"));
    command.addAll(List.of("--set", "CommunicationManager:COMMUNICATION MANAGER WAIT=60"));
    drives.put(rover, start(rover, "drive", command));
  }

  private void copy(String part, Path home) throws IOException {
    Files.createDirectories(home.resolve(part));
    try (Stream<Path> files = Files.list(repository.resolve(part))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Files.copy(file, home.resolve(part).resolve(file.getFileName()));
      }
    }
  }

  private Process start(String host, String name, List<String> program) throws IOException {
    Path log = folder.resolve(host).resolve(name + ".log");
    return new ProcessBuilder(lan.on(host, program))
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.appendTo(log.toFile()))
        .start();
  }

  /** Begins to send numbers of a rover's system from one host, and to count them at another. */
  Numbers numbers(String system, String from, String to) throws IOException {
    List<String> program =
        ThreeHosts.java(NumberedMain.class, "127.0.0.1", "" + Broker.PORT, system);
    Process sender =
        new ProcessBuilder(lan.on(from, program))
            .redirectError(folder.resolve(from).resolve("numbers.log").toFile())
            .start();
    return new Numbers(sender, lan.address(to), Broker.PORT, system);
  }

  /** Whether a rover is under way. */
  boolean isDriving(String rover) {
    return drives.get(rover).isAlive();
  }

  /** What the Mission Manager of a drive that is over said of the mission's end. */
  String end(String rover) throws IOException {
    Path log = folder.resolve(rover).resolve("out/logs/MissionManager.log");
    try (Stream<String> lines = Files.lines(log)) {
      return lines
          .filter(line -> line.contains(OVER))
          .map(line -> line.substring(line.indexOf(OVER)))
          .findFirst()
          .orElse("no mission was over");
    }
  }

  /** Whether all brokers run. */
  boolean allBrokersRun() {
    return brokers.values().stream().allMatch(Process::isAlive);
  }

  @Override
  public void close() throws IOException {
    drives.values().forEach(Process::destroy);
    brokers.values().forEach(Process::destroy);
    lan.close(); // and what has not ended by then
  }
}
