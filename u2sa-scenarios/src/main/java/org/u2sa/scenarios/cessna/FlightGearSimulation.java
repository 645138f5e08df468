package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.mission.Mission;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.trials.run.HomeFolder;
import org.u2sa.trials.run.Simulation;

/**
 * FlightGear, started headless by {@code scripts/flightgear/start} on this machine and stopped
 * after the flight, or started and stopped by the user according to printed instructions.
 */
final class FlightGearSimulation implements Simulation {
  private static final long LISTENS_WITHIN_S = 300; // 100 s observed on a busy machine
  private static final long ENDS_WITHIN_S = LISTENS_WITHIN_S + 60;

  private final Path scripts = HomeFolder.holding("config/cessna").resolve("scripts/flightgear");
  private final Path directory;
  private final RunwayStart start;
  private final FlightGearPorts ports;
  private final Optional<Terminal> told;
  private boolean started;

  /**
   * @param directory output directory of the run, for FlightGear's protocol files and the scripts'
   *     output
   * @param told receives instructions for starting FlightGear; empty if started by this process
   */
  FlightGearSimulation(
      FlightGearPorts ports, Path directory, Mission mission, Optional<Terminal> told) {
    this.ports = ports;
    this.directory = directory;
    this.start = EmbeddedStart.of(mission);
    this.told = told;
  }

  @Override
  public void start() throws InterruptedException {
    if (told.isPresent()) {
      tell(told.get().out());
      return;
    }
    Path data = directory.resolve("flightgear");
    try {
      Files.createDirectories(data);
      ProtocolFiles.writeTo(data);
    } catch (IOException e) {
      throw new RunFailedException(
          "cannot write FlightGear's protocol files to " + data + ": " + e.getMessage(), e);
    }
    started = true;
    run(
        List.of(
            scripts.resolve("start").toString(),
            "--data-dir",
            data.toString(),
            "--lon",
            number(start.longitudeDeg()),
            "--lat",
            number(start.latitudeDeg()),
            "--heading",
            number(Math.toDegrees(start.headingRad())),
            "--out-port",
            String.valueOf(ports.out()),
            "--in-port",
            String.valueOf(ports.in()),
            "--props-port",
            String.valueOf(ports.property()),
            "--wait",
            String.valueOf(LISTENS_WITHIN_S)));
  }

  private void tell(PrintWriter out) {
    out.printf(
        "Listening. Start FlightGear now, with%n"
            + "  --data=DIR --generic=socket,out,20,THIS-HOST,%d,tcp,u2sa-out --generic=socket,in,20,,%d,tcp,u2sa-in%s%n",
        ports.out(),
        ports.in(),
        ports.property() == 0 ? "" : " --props=socket,bi,20,," + ports.property() + ",tcp");
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.8f", value);
  }

  private void run(List<String> command) throws InterruptedException {
    Path log = directory.resolve("flightgear-" + Path.of(command.get(0)).getFileName() + ".log");
    try {
      Process process =
          new ProcessBuilder(new ArrayList<>(command))
              .redirectErrorStream(true)
              .redirectOutput(log.toFile())
              .start();
      if (!process.waitFor(ENDS_WITHIN_S, TimeUnit.SECONDS)) {
        process.destroy();
        throw new RunFailedException(
            command.get(0) + " did not end within " + ENDS_WITHIN_S + " s; see " + log);
      }
      if (process.exitValue() != 0) {
        throw new RunFailedException(
            command.get(0)
                + " ended with "
                + process.exitValue()
                + ": "
                + lastLine(log)
                + " (all of it in "
                + log
                + ")");
      }
    } catch (IOException e) {
      throw new RunFailedException(command.get(0) + " cannot be run: " + e.getMessage(), e);
    }
  }

  private static String lastLine(Path log) throws IOException {
    List<String> lines = Files.readAllLines(log);
    return lines.isEmpty() ? "it printed nothing" : lines.get(lines.size() - 1);
  }

  @Override
  public String name() {
    return "FlightGear";
  }

  @Override
  public String vehicle() {
    return "aircraft";
  }

  @Override
  public void close() {
    if (!started) {
      return;
    }
    try {
      run(List.of(scripts.resolve("stop").toString(), "--in-port", String.valueOf(ports.in())));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
