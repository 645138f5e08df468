package org.u2sa.trials.board;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.io.Writer;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.mission.Home;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.report.export.TrackCsv;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.TrackSample;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.file.VehicleInstruments;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioTcpServer;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.Interruption;
import org.u2sa.trials.run.SimulatedWorld;
import org.u2sa.trials.run.TruthObserver;
import org.u2sa.trials.run.VehicleFileChanges;
import org.u2sa.trials.run.WorldGaps;
import org.u2sa.world.xml.WorldFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code u2sa board}: serves a vehicle of a file as an IOIO board in real time. */
@Command(
    name = "board",
    description = {
      "Serve a simulated vehicle as an IOIO board, to a phone or a program on the network.",
      "",
      "In real time, until Ctrl-C. Connect the application via menu, Settings, Network, or a system via CONNECTION = tcp:HOST:PORT of IoioService "
          + "(docs/android.md). One host at a time; without one the motors get no pulses."
    })
final class BoardCommand implements Callable<Integer> {
  private static final int PORT = 4545; // IOIOLib's
  private static final int HIGHEST_PORT = 65_535;
  private static final double LOOKS_PER_S = 20.0;
  private static final double MAX_SILENT_S = 3_600.0;

  @Spec private CommandSpec command;

  @Option(
      names = "--vehicle",
      paramLabel = "FILE",
      required = true,
      description = "Vehicle file (XML).")
  private Path vehicleFile;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--listen",
      paramLabel = "ADDRESS[:PORT]",
      defaultValue = "127.0.0.1:4545",
      description =
          "Where to listen (default: ${DEFAULT-VALUE}); port 0: any. Addresses other than this host's own need --security.")
  private String listen;

  @Option(
      names = "--security",
      paramLabel = "FOLDER",
      description =
          "Folder created by ./u2sa security init: only its users with the role control are served, over TLS.")
  private Path security; // null for none

  @Option(
      names = "--allow-insecure-network",
      description =
          "Listen on a network without --security: everyone there can drive the simulated vehicle.")
  private boolean insecure;

  @Option(
      names = "--silent-after",
      paramLabel = "SECONDS",
      defaultValue = "5",
      description =
          "Time without a byte after which a host counts as gone (default: ${DEFAULT-VALUE} s); 0: never.")
  private double silentAfterS;

  @Option(names = "--world", paramLabel = "FILE", description = "World XML file. Default: nothing.")
  private Path worldFile; // null for an empty world

  @Option(
      names = "--start",
      paramLabel = "LONGITUDE,LATITUDE[,HEADING]",
      split = ",",
      description =
          "Where the vehicle starts [deg], at the altitude of the mission's home. Default: the home, else 0, 0 heading north.")
  private double[] start; // null if not given

  @Option(
      names = "--mission",
      paramLabel = "FILE",
      description = "Mission file at whose home the vehicle starts.")
  private Path missionFile; // null for none

  @Option(
      names = "--seed",
      defaultValue = "1",
      description = "Seed of the noise (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--serial",
      paramLabel = "FOLDER",
      description =
          "Offer the vehicle's serial devices, gps and compass, as serial ports in this folder. Needs socat.")
  private Path serial; // null for none

  @Option(
      names = "--out",
      paramLabel = "FOLDER",
      description = "Write the true track, track.csv, to this folder.")
  private Path out; // null for none

  @Option(names = "--status", description = "Print the true state once a second.")
  private boolean status;

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (!(silentAfterS >= 0.0 && silentAfterS <= MAX_SILENT_S)) {
      throw new BadInputException(
          "--silent-after " + silentAfterS + ": expected 0 to " + MAX_SILENT_S + " s");
    }
    InetSocketAddress address = address();
    if (!address.getAddress().isLoopbackAddress() && security == null && !insecure) {
      throw new BadInputException(
          "--listen "
              + listen
              + " opens the board to a network, but it has neither users nor encryption: "
              + "./u2sa security init creates both in the folder security; pass it with --security, "
              + "or use --allow-insecure-network");
    }
    VehicleFile vehicle = changes.load(vehicleFile);
    Place place = place();
    World world = world(vehicle, place);
    BoardedVehicle boarded = BoardedVehicle.of(vehicle, world, place.headingRad(), seed);
    try (Interruption interruption = new Interruption()) {
      serve(vehicle, boarded, address, interruption);
    }
    return ExitCode.DONE;
  }

  private InetSocketAddress address() {
    int colon = listen.lastIndexOf(':');
    boolean hasPort =
        colon >= 0 && !listen.endsWith("]") && listen.indexOf(':') == colon
            || listen.contains("]:");
    String host = hasPort ? listen.substring(0, colon) : listen;
    try {
      int port = hasPort ? Integer.parseInt(listen.substring(colon + 1)) : PORT;
      if (port >= 0 && port <= HIGHEST_PORT && !host.isEmpty()) {
        return new InetSocketAddress(InetAddress.getByName(host), port);
      }
    } catch (NumberFormatException | UnknownHostException e) {
      throw new BadInputException(wrongAddress(), e);
    }
    throw new BadInputException(wrongAddress());
  }

  private String wrongAddress() {
    return "--listen " + listen + ": expected ADDRESS or ADDRESS:PORT of this machine";
  }

  private record Place(Geodetic at, double headingRad) {}

  private Place place() {
    Optional<Home> home = missionFile == null ? Optional.empty() : Mission.load(missionFile).home();
    Geodetic at = home.flatMap(Home::geodetic).orElse(new Geodetic(0.0, 0.0, 0.0));
    if (start != null) {
      if (start.length < 2
          || start.length > 3
          || !(Math.abs(start[0]) <= 180.0 && Math.abs(start[1]) <= 85.0)
          || start.length == 3 && !Double.isFinite(start[2])) {
        throw new BadInputException(
            "--start: expected LONGITUDE,LATITUDE[,HEADING] in degrees, at most 85 degrees north or south");
      }
      return new Place(
          new Geodetic(start[0], start[1], at.altitudeM()),
          Math.toRadians(start.length > 2 ? start[2] : 0.0));
    }
    return new Place(at, home.map(there -> there.headingRad().orElse(0.0)).orElse(0.0));
  }

  private World world(VehicleFile vehicle, Place place) {
    World empty = World.at(place.at());
    if (worldFile == null) {
      return vehicle.home(empty);
    }
    WorldFile around = WorldFile.load(worldFile);
    WorldGaps.tell(around, this::say);
    return vehicle.home(SimulatedWorld.read(around, worldFile, empty, seed));
  }

  private void say(String line) {
    PrintWriter text = command.commandLine().getOut();
    text.println(line);
    text.flush();
  }

  private void serve(
      VehicleFile vehicle,
      BoardedVehicle boarded,
      InetSocketAddress address,
      Interruption interruption)
      throws IOException, InterruptedException {
    Clock clock = new SystemClock();
    AtomicReference<RuntimeException> failure = new AtomicReference<>();
    Optional<BoardUsers> users =
        security == null
            ? Optional.empty()
            : Optional.of(new BoardUsers(security, clock, this::say));
    if (users.isEmpty() && !address.getAddress().isLoopbackAddress()) {
      say("WARNING: everyone who reaches " + listen + " can drive this simulated vehicle");
    }
    try (Clock.Waiter waiter = clock.newWaiter("board");
        Writer track = track();
        BoardGate gate =
            new BoardGate(
                address,
                clock,
                users,
                silentAfterS,
                new PacedLog(clock, this::say),
                why -> {
                  failure.set(why);
                  waiter.signal();
                });
        IoioTcpServer server =
            new IoioTcpServer(new IoioFirmware(IoioBoard.OTG, boarded.pins()), clock, gate)) {
      interruption.onRequest(
          () -> {
            failure.compareAndSet(null, new Ended());
            waiter.signal();
          });
      String at = gate.address().getAddress().getHostAddress() + ":" + gate.address().getPort();
      say(
          String.format(
              "%s: IOIO board at %s:%s; actuators %s",
              vehicle.name(), users.isPresent() ? "tls" : "tcp", at, boarded.wiring()));
      long begin = clock.micros();
      Supplier<String> host = () -> server.isConnected() ? gate.host().orElse("none") : "none";
      if (serial == null) {
        watch(clock, waiter, boarded, host, track, failure);
        return;
      }
      try (SerialPorts ports =
          new SerialPorts(
              VehicleInstruments.of(
                  vehicle, boarded.run(), () -> BoardedVehicle.BEFORE_THE_START, seed),
              serial,
              () -> clock.micros() - begin,
              this::say)) {
        ports.ports().forEach(port -> say("serial:" + port));
        watch(clock, waiter, boarded, host, track, failure);
      }
    }
  }

  private Writer track() throws IOException {
    if (out == null) {
      return Writer.nullWriter();
    }
    Files.createDirectories(out);
    return new BufferedWriter(
        new OutputStreamWriter(
            ReportFile.newOutputStream(out.resolve("track.csv")), StandardCharsets.UTF_8));
  }

  private void watch(
      Clock clock,
      Clock.Waiter waiter,
      BoardedVehicle boarded,
      Supplier<String> host,
      Writer track,
      AtomicReference<RuntimeException> failure)
      throws IOException, InterruptedException {
    TrackCsv.write(track, Domain.GROUND, List.of());
    double lastS = Double.NEGATIVE_INFINITY;
    long statusMicros = clock.micros();
    while (failure.get() == null) {
      waiter.await(clock.micros() + Clock.micros(1.0 / LOOKS_PER_S));
      VehicleTruth truth = boarded.truth();
      if (truth.timeS() > lastS) {
        lastS = truth.timeS();
        TrackCsv.append(track, Domain.GROUND, sample(boarded, truth));
      }
      if (status && clock.micros() >= statusMicros) {
        statusMicros += Clock.MICROS_PER_SECOND;
        say(statusLine(boarded, truth, host.get()));
        track.flush();
      }
    }
    if (!(failure.get() instanceof Ended)) {
      throw failure.get();
    }
  }

  private static TrackSample sample(BoardedVehicle boarded, VehicleTruth truth) {
    Geodetic at = boarded.place(truth);
    return new TrackSample(
        truth.timeS(),
        at.longitudeDeg(),
        at.latitudeDeg(),
        at.altitudeM(),
        truth.headingRad(),
        truth.speedMps(),
        OptionalDouble.empty(),
        -1,
        TruthObserver.moves(truth) ? "MOVES" : "STANDS",
        Optional.empty());
  }

  private static String statusLine(BoardedVehicle boarded, VehicleTruth truth, String host) {
    Geodetic at = boarded.place(truth);
    String outputs =
        boarded.outputs().entrySet().stream()
            .map(
                each ->
                    each.getKey()
                        + (each.getValue().isNaN()
                            ? " no signal"
                            : String.format(Locale.ROOT, " %.0f %%", 100.0 * each.getValue())))
            .collect(Collectors.joining(", "));
    return String.format(
        Locale.ROOT,
        "%.1f s: longitude %.7f, latitude %.7f, altitude %.2f m, heading %.1f deg, %.2f m/s; %s; contacts %d; host %s",
        truth.timeS(),
        at.longitudeDeg(),
        at.latitudeDeg(),
        at.altitudeM(),
        Math.toDegrees(truth.headingRad()),
        truth.speedMps(),
        outputs,
        boarded.run().contacts().size(),
        host);
  }

  /** Set when termination is requested. */
  private static final class Ended extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }
}
