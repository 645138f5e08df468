package org.u2sa.chaos;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.u2sa.cli.Main;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.flightgear.link.StandInFlightGear;
import org.u2sa.flightgear.link.StandInSetup;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.mission.Mission;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.ProcessTree;

/**
 * A Cessna in the stand-in simulator, flown by {@code u2sa run --separate}: one process a service,
 * as a user would start it. The aircraft flies in this process, whatever becomes of the services.
 */
final class Vehicle implements AutoCloseable {
  private static final String HOST = "127.0.0.1";
  private static final String ONLY = "--only";

  /** Lets this process hold single threads of the services (JDWP, any free port). */
  private static final String DEBUGGABLE =
      "-agentlib:jdwp=transport=dt_socket,server=y,suspend=n,quiet=y,address=127.0.0.1:0";

  private final StandInFlightGear aircraft;
  private final int outPort;
  private final Process supervisor;

  /**
   * @param folder a copy of the repository's {@code config} and {@code missions}; logs go there too
   * @param brokerPort where the services find their broker
   */
  Vehicle(Path folder, int brokerPort, Wind wind) throws IOException {
    Path mission = folder.resolve("missions/cessna/mission.xml");
    outPort = FreePort.find();
    aircraft =
        new StandInFlightGear(
            Cessna172.onRunway(EmbeddedStart.of(Mission.load(mission)), wind, true),
            StandInSetup.likeFlightGear(),
            HOST,
            0,
            0,
            new SystemClock());
    supervisor = start(folder, brokerPort);
    aircraft.start(HOST, outPort);
  }

  private Process start(Path folder, int brokerPort) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Du2sa.home=" + folder,
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "run",
                folder.resolve("config/cessna/system.xml").toString(),
                "--separate",
                "--logs",
                folder.resolve("logs").toString()));
    Map<String, Object> settings = new TreeMap<>();
    settings.put("CommunicationManager:BROKER", "external");
    settings.put("CommunicationManager:COMMUNICATION MANAGER PORT", brokerPort);
    settings.put("Simulator:LINK", "flightgear");
    settings.put("Simulator:RATE", 100.0);
    settings.put("Simulator:FLIGHTGEAR OUT PORT", outPort);
    settings.put("Simulator:FLIGHTGEAR IN PORT", aircraft.inPort());
    settings.put("Simulator:FLIGHTGEAR PROPERTY PORT", aircraft.propertyPort());
    settings.put("MissionManager:LOOP", true);
    settings.put("HealthMonitor:Simulator POLICY", "RESTART"); // the aircraft is another process
    settings.put("HealthMonitor:RESTART WINDOW", 10.0); // no real service breaks every few seconds
    settings.forEach((name, value) -> command.addAll(List.of("--set", name + "=" + value)));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().put("JAVA_TOOL_OPTIONS", DEBUGGABLE);
    return builder.redirectOutput(folder.resolve("supervisor.log").toFile()).start();
  }

  /** What the aircraft said last: the truth. */
  OutLine truth() {
    return aircraft.said();
  }

  /** Where the Simulator service awaits the aircraft's lines. */
  int linesPort() {
    return outPort;
  }

  /** Where the aircraft awaits controls. */
  int controlsPort() {
    return aircraft.inPort();
  }

  boolean isSupervised() {
    return supervisor.isAlive();
  }

  /** The services' processes that run now, by the simple name of the service's class. */
  Map<String, ProcessHandle> processes() {
    Map<String, ProcessHandle> byName = new TreeMap<>();
    supervisor
        .toHandle()
        .descendants()
        .filter(ProcessHandle::isAlive)
        .forEach(process -> serviceOf(process).forEach(name -> byName.put(name, process)));
    return byName;
  }

  private static List<String> serviceOf(ProcessHandle process) {
    try {
      List<String> words =
          List.of(Files.readString(Path.of("/proc", "" + process.pid(), "cmdline")).split("\0"));
      int only = words.indexOf(ONLY);
      return only < 0 ? List.of() : List.of(words.get(only + 1));
    } catch (IOException e) {
      return List.of(); // it ended while we looked
    }
  }

  @Override
  public void close() {
    List<ProcessHandle> children = supervisor.toHandle().descendants().toList();
    children.forEach(process -> Signal.CONT.send(process)); // one that is stopped cannot end
    ProcessTree.end(supervisor);
    aircraft.close();
  }

  /** Copies the repository's files of the Cessna, for a vehicle of its own. */
  static void copyFiles(Path repository, Path folder) throws IOException {
    for (String part : List.of("config/cessna", "missions/cessna")) {
      Files.createDirectories(folder.resolve(part));
      try (Stream<Path> files = Files.list(repository.resolve(part))) {
        files.forEach(
            file -> {
              try {
                Files.copy(file, folder.resolve(part).resolve(file.getFileName()));
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            });
      }
    }
  }
}
