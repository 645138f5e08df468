import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.cli.Main;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.VehicleDevices;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.world.xml.WorldFile;

/**
 * Simulated seconds a second, in one virtual machine: vehicles of vehicle files with their sensors alone, and whole systems in lockstep. Each case
 * is repeated; the first rounds, which compile, are left out, and the medians of the others are printed, by the wall clock and by processor time.
 *
 * <p>Arguments: names of cases ({@code --list} prints them), and {@code --rounds N}.
 */
final class Pace {
  private static final int COLD = 2; // rounds left out, if there are more
  private static final double ALONE_S = 3_600.0;
  private static final int VEHICLES = 10;
  private static final Path HOME = Path.of(System.getProperty("u2sa.home"));
  private static final OperatingSystemMXBean PROCESS = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

  /** What a round took. */
  private record Cost(double simulatedS, double wallS, double cpuS) {}

  /** One round of a case. */
  private interface Round {
    Cost run() throws Exception;
  }

  /**
   * A case.
   *
   * @param goal issue's bar [simulated s/s]
   */
  private record Case(String name, double goal, Round round) {}

  private static final class Ticks implements Clock {
    private long now;

    @Override
    public long micros() {
      return now;
    }

    @Override
    public Waiter newWaiter(String name) {
      throw new UnsupportedOperationException("nobody waits");
    }
  }

  /** Drives a vehicle at one time. */
  private interface Driver {
    void drive(VehicleRun run, long micros);
  }

  private Pace() {}

  public static void main(String[] args) throws Exception {
    List<String> wanted = new ArrayList<>(Arrays.asList(args));
    wanted.removeIf(word -> word.matches("\\d+") && !wanted.contains("--rounds")); // ports, which benchmarks/run gives to all
    int rounds = 7;
    int at = wanted.indexOf("--rounds");
    if (at >= 0) {
      rounds = Integer.parseInt(wanted.get(at + 1));
      wanted.subList(at, at + 2).clear();
    }
    System.out.printf(
        Locale.ROOT,
        "%d cores, load average %s, Java %s, %d rounds of which %d are left out%n",
        Runtime.getRuntime().availableProcessors(),
        load(),
        System.getProperty("java.version"),
        rounds,
        COLD);
    System.out.printf("%-32s %6s %12s %12s %8s  %s%n", "case", "bar", "wall", "processor", "load", "all rounds, by processor");
    for (Case each : cases()) {
      if (wanted.contains("--list")) {
        System.out.println(each.name());
      } else if (wanted.isEmpty() || wanted.contains(each.name())) {
        measure(each, rounds);
      }
    }
  }

  private static String load() throws IOException {
    return Files.readString(Path.of("/proc/loadavg")).split(" ")[0];
  }

  private static void measure(Case each, int rounds) throws Exception {
    double[] wall = new double[rounds];
    double[] cpu = new double[rounds];
    for (int i = 0; i < rounds; i++) {
      Cost cost = each.round().run();
      wall[i] = cost.simulatedS() / cost.wallS();
      cpu[i] = cost.simulatedS() / cost.cpuS();
    }
    StringBuilder all = new StringBuilder();
    for (double pace : cpu) {
      all.append(String.format(Locale.ROOT, " %.0f", pace));
    }
    System.out.printf(
        Locale.ROOT, "%-32s %6.0f %12.1f %12.1f %8s %s%n", each.name(), each.goal(), median(wall), median(cpu), load(), all);
  }

  private static double median(double[] values) {
    double[] warm = Arrays.copyOfRange(values, Math.min(COLD, values.length - 1), values.length);
    Arrays.sort(warm);
    return (warm[(warm.length - 1) / 2] + warm[warm.length / 2]) / 2.0;
  }

  private static List<Case> cases() {
    Path rover = HOME.resolve("config/ugv/vehicle.xml");
    Path copterFolder = HOME.resolve("u2sa-scenarios/src/test/resources/org/u2sa/scenarios/simulate/copter");
    Path copter = copterFolder.resolve("vehicle.xml");
    List<Class<? extends Device<?>>> usual = List.of(GpsReceiver.class, Compass.class, Imu.class, WheelEncoder.class);
    List<Class<? extends Device<?>>> seeing =
        List.of(GpsReceiver.class, Compass.class, Imu.class, WheelEncoder.class, LaserScanner.class);
    List<Class<? extends Device<?>>> flying = List.of(GpsReceiver.class, Compass.class, Imu.class);
    Path obstacles = HOME.resolve("missions/ugv/obstructed.xml");
    return List.of(
        new Case("vehicle/rover", 1000, () -> alone(rover, usual, 1, 100, Pace::weave)),
        new Case("vehicle/rover-lidar", 200, () -> alone(rover, seeing, 1, 100, Pace::weave)),
        new Case("vehicle/multirotor-400Hz", 500, () -> alone(copter, flying, 1, 400, Pace::hover)),
        new Case("vehicle/ten-rovers", 20, () -> alone(rover, usual, VEHICLES, 100, Pace::weave)),
        new Case("vehicle/ten-rovers-lidar", 20, () -> alone(rover, seeing, VEHICLES, 100, Pace::weave)),
        new Case("system/rover", 1000, () -> system("demo", "ugv", "--seed", "1")),
        new Case("system/rover-pass-through", 1000, () -> system("demo", "ugv", "--seed", "1", "--estimator", "pass_through")),
        new Case("system/rover-lidar", 200, () -> system("demo", "ugv", "--loops", "5", "--world", obstacles.toString(), "--seed", "1")),
        new Case("system/multirotor", 500, () -> copter(copterFolder, "--seed", "1")),
        new Case(
            "system/multirotor-400Hz",
            500,
            () -> copter(copterFolder, "--seed", "1", "--set", "ImuSensor:RATE=400", "--set", "FusingStateEstimator:OUTPUT RATE=400", "--change", "imu/rate=400")),
        new Case("system/igvc", 20, () -> system("demo", "igvc", "--seed", "701")));
  }

  private static Cost copter(Path folder, String... more) throws IOException {
    List<String> words = new ArrayList<>(List.of("simulate", folder.resolve("system.xml").toString(), "--vehicle", folder.resolve("vehicle.xml").toString()));
    words.addAll(List.of(more));
    return system(words.toArray(new String[0]));
  }

  /** A vehicle, or several in one world among the obstacles of the ground vehicle's course, and their sensors, read at a rate. */
  private static Cost alone(Path vehicle, List<Class<? extends Device<?>>> ports, int count, int hz, Driver driver) {
    VehicleFile file = VehicleFile.load(vehicle);
    World world =
        World.at(new Geodetic(-81.0478, 29.18858, 0.0)).with(WorldFile.load(HOME.resolve("missions/ugv/obstructed.xml")).objects());
    Ticks clock = new Ticks();
    List<VehicleRun> runs = new ArrayList<>();
    List<Device<?>> devices = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      VehicleRun run = (VehicleRun) file.running(world, Point.of(3.0 * i - 15.0, 5.0, 0.0), 0.6 * i, i + 1);
      runs.add(run);
      VehicleDevices aboard = new VehicleDevices(file, run, i + 1);
      for (Class<? extends Device<?>> port : ports) {
        devices.add(aboard.device(port, port.getSimpleName(), XmlConfiguration.inMemory("benchmark", Map.of()), clock).orElseThrow());
      }
    }
    long began = System.nanoTime();
    long cpu = PROCESS.getProcessCpuTime();
    long last = Math.round(ALONE_S / count * 1e6);
    long step = 1_000_000L / hz;
    double sum = 0.0;
    for (clock.now = 0; clock.now < last; clock.now += step) {
      for (VehicleRun run : runs) {
        driver.drive(run, clock.now);
      }
      for (Device<?> device : devices) {
        sum += device.read(clock.now).isPresent() ? 1.0 : 0.0;
      }
    }
    if (!(sum > 0.0)) {
      throw new IllegalStateException("no readings");
    }
    return new Cost(ALONE_S / count, (System.nanoTime() - began) * 1e-9, (PROCESS.getProcessCpuTime() - cpu) * 1e-9);
  }

  private static void weave(VehicleRun run, long micros) {
    double wave = 0.15 * Math.sin(micros * 2e-7);
    List<String> sides = run.vehicle().actuators();
    run.command(micros, sides.get(0), 0.5 + wave);
    run.command(micros, sides.get(1), 0.5 - wave);
  }

  /** Height and level attitude at each tick. */
  private static void hover(VehicleRun run, long micros) {
    VehicleTruth truth = run.at(micros);
    double thrust = 0.6 + 0.1 * (3.0 - truth.position().z()) - 0.1 * truth.velocity().z();
    double roll = -0.1 * truth.attitude().phi() - 0.03 * truth.rates().x();
    double pitch = -0.1 * truth.attitude().theta() - 0.03 * truth.rates().y();
    List<String> rotors = run.vehicle().actuators();
    for (int i = 0; i < rotors.size(); i++) {
      double angle = 2.0 * Math.PI * i / rotors.size(); // clockwise from ahead
      double command = thrust - roll * Math.sin(angle) + pitch * Math.cos(angle);
      run.command(micros, rotors.get(i), Math.max(0.0, Math.min(1.0, command)));
    }
  }

  private static final Pattern SIMULATED = Pattern.compile("\"simSeconds\" : ([0-9.]+)");
  private static final Pattern WALL = Pattern.compile("\"wallSeconds\" : ([0-9.]+)");

  /** A command line's run, without the thread that reads files before it and draws the report after it. */
  private static Cost system(String... words) throws IOException {
    Path out = Files.createTempDirectory("u2sa-pace");
    List<String> all = new ArrayList<>(List.of(words));
    all.addAll(List.of("--port", "0", "--out", out.toString(), "--summary-only"));
    long cpu = othersNanos();
    int exit =
        Main.run(new PrintWriter(OutputStream.nullOutputStream()), new PrintWriter(System.err, true), all.toArray(new String[0]));
    double cpuS = (othersNanos() - cpu) * 1e-9;
    if (exit == 2) {
      throw new IllegalStateException(all + " was refused");
    }
    String summary = Files.readString(out.resolve("summary.json"));
    return new Cost(number(SIMULATED, summary), number(WALL, summary), cpuS);
  }

  private static long othersNanos() {
    return PROCESS.getProcessCpuTime() - ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private static double number(Pattern pattern, String text) {
    Matcher matcher = pattern.matcher(text);
    if (!matcher.find()) {
      throw new IllegalStateException("summary.json lacks " + pattern);
    }
    return Double.parseDouble(matcher.group(1));
  }
}
