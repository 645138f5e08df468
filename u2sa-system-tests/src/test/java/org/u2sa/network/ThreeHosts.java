package org.u2sa.network;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.u2sa.cli.Main;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.testkit.ProcessTree;

/**
 * The Cessna's system on three hosts, from one system file: {@code hub} carries the broker, mission
 * and safety, {@code aircraft} the simulator and the estimator, {@code pilot} planner and control.
 */
final class ThreeHosts implements AutoCloseable {
  static final String SYSTEM = "cessna";
  static final String HUB = "hub";
  static final String AIRCRAFT = "aircraft";
  static final String PILOT = "pilot";

  private static final Map<String, String> HOSTS =
      Map.of(
          "Simulator", AIRCRAFT,
          "PassThroughStateEstimator", AIRCRAFT,
          "PathPlanner", PILOT,
          "CessnaControl", PILOT);
  private static final int OUT_PORT = 5501;
  private static final int IN_PORT = 5502;
  private static final int PROPERTY_PORT = 5503;

  private final Path folder;
  private final Path system;
  private final Lan lan;
  private final Broker kind;
  private final List<SystemFile.Entry> services;
  private final Map<String, Process> processes = new LinkedHashMap<>(); // by host, and the broker's
  private final Aircraft aircraft;
  private Process broker;

  /** Copies the repository's files and starts the aircraft; no service yet. */
  ThreeHosts(Path repository, Path folder, Broker kind) throws IOException, InterruptedException {
    this.folder = folder;
    this.kind = kind;
    copy(repository, folder, "config/cessna");
    Path mission = folder.resolve("missions/cessna/mission.xml");
    Files.createDirectories(mission.getParent());
    try (InputStream waypoints = ThreeHosts.class.getResourceAsStream("three-waypoints.xml")) {
      Files.copy(waypoints, mission);
    }
    system = folder.resolve("config/cessna/system.xml");
    if (kind == Broker.EMBEDDED) {
      nameHosts(system);
    }
    services = SystemFile.read(system).services();
    lan = new Lan(repository, folder, HUB, AIRCRAFT, PILOT);
    List<String> program =
        java(
            AircraftMain.class,
            mission.toString(),
            "" + OUT_PORT,
            "" + IN_PORT,
            "" + PROPERTY_PORT);
    aircraft =
        new Aircraft(
            new ProcessBuilder(lan.on(AIRCRAFT, program))
                .redirectError(folder.resolve("aircraft.log").toFile())
                .start());
  }

  /** Writes into a system file which host carries what; the broker has a process of its own. */
  private static void nameHosts(Path system) throws IOException {
    String text =
        Files.readString(system).replace("<communication ", "<communication host=\"broker\" ");
    Matcher service = Pattern.compile("<service class=\"[^\"]*?(\\w+)\"").matcher(text);
    Files.writeString(
        system,
        service.replaceAll(found -> found.group() + " host=\"" + hostOf(found.group(1)) + '"'));
  }

  private static String hostOf(String service) {
    return HOSTS.getOrDefault(service, HUB);
  }

  private static void copy(Path repository, Path folder, String part) throws IOException {
    Files.createDirectories(folder.resolve(part));
    try (Stream<Path> files = Files.list(repository.resolve(part))) {
      for (Path file : files.toList()) {
        Files.copy(file, folder.resolve(part).resolve(file.getFileName()));
      }
    }
  }

  static List<String> java(Class<?> main, String... arguments) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
    command.addAll(List.of(arguments));
    return command;
  }

  Lan lan() {
    return lan;
  }

  Aircraft aircraft() {
    return aircraft;
  }

  /** Services in the system file, and a launcher a host. */
  int size() {
    return services.size() + 3;
  }

  /** Starts what the host carries, the broker apart. */
  void start(String host) throws IOException {
    processes.put(host, start(host, host, runOn(host)));
  }

  private List<String> runOn(String host) {
    if (kind == Broker.EMBEDDED) {
      return run(host, "--host", host);
    }
    String only =
        String.join(
            ",",
            services.stream()
                .map(SystemFile.Entry::simpleName)
                .filter(name -> hostOf(name).equals(host))
                .toList());
    return run(host, "--only", only);
  }

  private List<String> run(String logs, String... which) {
    Map<String, Object> settings = new LinkedHashMap<>();
    boolean announced = kind == Broker.EMBEDDED; // and found by mDNS
    settings.put(
        "CommunicationManager:COMMUNICATION MANAGER IP", announced ? "auto" : lan.address(HUB));
    settings.put("CommunicationManager:COMMUNICATION MANAGER PORT", Broker.PORT);
    settings.put("CommunicationManager:COMMUNICATION MANAGER WAIT", 60.0);
    settings.put("CommunicationManager:BIND ADDRESS", lan.address(HUB));
    settings.put("CommunicationManager:ALLOW INSECURE NETWORK", true);
    settings.put("Simulator:LINK", "flightgear");
    settings.put("Simulator:RATE", 100.0);
    settings.put("Simulator:FLIGHTGEAR OUT PORT", OUT_PORT);
    settings.put("Simulator:FLIGHTGEAR IN PORT", IN_PORT);
    settings.put("Simulator:FLIGHTGEAR PROPERTY PORT", PROPERTY_PORT);
    List<String> command = new ArrayList<>(java(Main.class, "run", system.toString()));
    command.addAll(List.of(which));
    command.addAll(List.of("--logs", folder.resolve("logs-" + logs).toString()));
    settings.forEach((name, value) -> command.addAll(List.of("--set", name + "=" + value)));
    return command;
  }

  private Process start(String host, String name, List<String> program) throws IOException {
    return new ProcessBuilder(lan.on(host, program))
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.appendTo(folder.resolve(name + ".log").toFile()))
        .start();
  }

  void startBroker() throws IOException {
    List<String> run = run("broker", "--host", "broker");
    broker = start(HUB, "broker", kind.program(folder, lan.address(HUB), run));
  }

  /** Begins to send numbers from a host. */
  Numbers numbersFrom(String host) throws IOException {
    List<String> program = java(NumberedMain.class, lan.address(HUB), "" + Broker.PORT, SYSTEM);
    Process sender =
        new ProcessBuilder(lan.on(host, program))
            .redirectError(folder.resolve("numbers.log").toFile())
            .start();
    return new Numbers(sender, lan.address(HUB), Broker.PORT, SYSTEM);
  }

  /** kill −9. */
  void killBroker() throws InterruptedException {
    broker.destroyForcibly().waitFor();
  }

  /** kill −9 for all services of a host. */
  void kill(String host) throws InterruptedException {
    processes.get(host).destroyForcibly().waitFor();
  }

  /** Whether what was started still runs. */
  boolean allRun() {
    return broker.isAlive() && processes.values().stream().allMatch(Process::isAlive);
  }

  /** The log of a service on a host. */
  String log(String host, String service) {
    try {
      return Files.readString(folder.resolve("logs-" + host).resolve(service + ".log"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    processes.values().forEach(ProcessTree::end);
    if (broker != null) {
      ProcessTree.end(broker);
    }
    aircraft.close();
    lan.close(); // and what has not ended by then
  }
}
