package org.u2sa.benchmarks.fleet;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/** Many vehicles on one broker, broker after broker, round by round. */
public final class FleetBenchmark {
  private static final String HELP =
      """
      --brokers A,B    %s
      --vehicles 1000  each with a connection of its own
      --hz 10          states a second of each
      --seconds 20     of each measurement, after a quarter of it that warms up
      --rounds 3       in which the brokers take turns
      --json FILE      each round's figures
      """
          .formatted(String.join(",", BrokerProcess.ALL));

  private static final double SLOWLY_HZ = 0.5;
  private static final double MICROS = 1e6;

  private final Map<String, String> options = new LinkedHashMap<>();
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());
  private final List<Result> results = new ArrayList<>();

  private FleetBenchmark(String[] args) {
    options.put("--brokers", String.join(",", BrokerProcess.ALL));
    options.put("--vehicles", "1000");
    options.put("--hz", "10");
    options.put("--seconds", "20");
    options.put("--rounds", "3");
    options.put("--json", "");
    for (int i = 0; i < args.length; i += 2) {
      if (!options.containsKey(args[i]) || i + 1 == args.length) {
        throw new IllegalArgumentException(args[i] + ": expected\n" + HELP);
      }
      options.put(args[i], args[i + 1]);
    }
  }

  private double number(String option) {
    return Double.parseDouble(options.get(option));
  }

  private void run() throws Exception {
    System.out.printf(
        Locale.ROOT,
        "%d cores, load average %.2f, Java %s; %s vehicles at %s Hz%n",
        Runtime.getRuntime().availableProcessors(),
        load(),
        System.getProperty("java.version"),
        options.get("--vehicles"),
        options.get("--hz"));
    for (int round = 1; round <= number("--rounds"); round++) {
      for (String broker : options.get("--brokers").split(",")) {
        if (BrokerProcess.isHere(broker)) {
          results.add(measure(broker, round));
        } else {
          System.err.println(broker + " is not on the path: left out");
        }
      }
    }
    System.out.print(Result.table(results));
    System.out.printf(Locale.ROOT, "load average at the end %.2f%n", load());
    if (!options.get("--json").isEmpty()) {
      Files.writeString(Path.of(options.get("--json")), Result.json(results));
    }
  }

  private Result measure(String name, int round) throws Exception {
    Path folder = Files.createTempDirectory("u2sa-fleet");
    try (BrokerProcess broker = new BrokerProcess(name, folder);
        Ground ground = new Ground(broker.port(), codec);
        Vehicles vehicles = new Vehicles((int) number("--vehicles"), broker.port(), codec)) {
      double hz = number("--hz");
      double seconds = number("--seconds");
      run(vehicles, ground, hz, seconds / 4);
      ground.reset();
      long missedBefore = ground.missed();
      long refusedBefore = vehicles.refused();
      double cpuBefore = broker.cpuS();
      double oursBefore = ownCpuS();
      long sent = run(vehicles, ground, hz, seconds);
      Result result =
          new Result(
              name,
              round,
              (int) number("--vehicles"),
              sent,
              ground.arrived(),
              vehicles.refused() - refusedBefore,
              ground.missed() - missedBefore,
              ground.latencyMs(50.0),
              ground.latencyMs(99.0),
              ground.latencyMs(99.9),
              (broker.cpuS() - cpuBefore) / sent * MICROS,
              (ownCpuS() - oursBefore) / sent * MICROS,
              broker.memoryMb());
      System.err.println(result.json());
      return result;
    } finally {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }

  /**
   * Has all vehicles publish, and one more of each at the end: what is gone shows as a gap then.
   */
  private static long run(Vehicles vehicles, Ground ground, double hz, double seconds)
      throws InterruptedException {
    long sent = vehicles.publish(hz, seconds);
    settle(ground, sent);
    sent += vehicles.publish(SLOWLY_HZ, 1.0 / SLOWLY_HZ);
    settle(ground, sent);
    return sent;
  }

  /** Waits until all have arrived, or none has for three seconds. */
  private static void settle(Ground ground, long expected) throws InterruptedException {
    long last = -1;
    for (int quiet = 0; quiet < 30 && ground.arrived() < expected; quiet++) {
      if (ground.arrived() != last) {
        last = ground.arrived();
        quiet = 0;
      }
      Thread.sleep(100);
    }
  }

  private static double ownCpuS() {
    return ProcessHandle.current().info().totalCpuDuration().orElseThrow().toNanos() / 1e9;
  }

  private static double load() {
    return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
  }

  public static void main(String[] args) throws Exception {
    if (Arrays.asList(args).contains("--help")) {
      System.out.print(HELP);
      return;
    }
    try {
      new FleetBenchmark(args).run();
      System.exit(0);
    } catch (Exception e) {
      e.printStackTrace();
      System.exit(1); // running services would keep the process alive
    }
  }
}
