package org.u2sa.benchmarks.chain;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;

/** Measures the chain's scenarios in turn, round by round, so that all have the same load of the machine. */
public final class ChainBenchmark {
  private static final String HELP =
      """
      --hz 50,400           measurements of the IMU a second
      --neighbours 1,10,50  services that publish and listen at 50 Hz
      --company slow,recorder  what else runs, each with 10 neighbours: a slow subscriber, the recorder; none: nothing
      --seconds 10          of each measurement
      --warm-up 5           before it [s]
      --rounds 2            the first warms up, and is not counted
      --spin 0              SPIN of all services [us]
      --json FILE           each round's figures
      """;
  private static final int COMPANY_NEIGHBOURS = 10;

  private final Map<String, String> options = new LinkedHashMap<>();

  private ChainBenchmark(String[] args) {
    options.put("--hz", "50,400");
    options.put("--neighbours", "1,10,50");
    options.put("--company", "slow,recorder");
    options.put("--seconds", "10");
    options.put("--warm-up", "5");
    options.put("--rounds", "2");
    options.put("--spin", "0");
    options.put("--json", "");
    for (int i = 0; i < args.length; i += 2) {
      if (!options.containsKey(args[i]) || i + 1 == args.length) {
        throw new IllegalArgumentException(args[i] + ": expected\n" + HELP);
      }
      options.put(args[i], args[i + 1]);
    }
  }

  private List<String> list(String option) {
    return Arrays.asList(options.get(option).split(","));
  }

  private double number(String option) {
    return Double.parseDouble(options.get(option));
  }

  private List<Scenario> scenarios() {
    List<Scenario> all = new ArrayList<>();
    for (String hz : list("--hz")) {
      for (String neighbours : list("--neighbours")) {
        all.add(new Scenario(Integer.parseInt(hz), Integer.parseInt(neighbours), "none"));
      }
      for (String company : list("--company")) {
        if (!company.equals("none")) {
          all.add(new Scenario(Integer.parseInt(hz), COMPANY_NEIGHBOURS, company));
        }
      }
    }
    return all;
  }

  private void run() throws Exception {
    System.out.printf(
        Locale.ROOT,
        "%d cores, load average %.2f, Java %s, %s, SPIN %s us, from the IMU's measurement to the last motor's callback%n",
        Runtime.getRuntime().availableProcessors(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"),
        ManagementFactory.getGarbageCollectorMXBeans().stream()
            .map(GarbageCollectorMXBean::getName)
            .collect(Collectors.joining(" and ")),
        options.get("--spin"));
    Path config = Path.of(System.getProperty("u2sa.home")).resolve("config/ugv");
    Map<String, Object> forAll = number("--spin") > 0 ? Map.of("SPIN", number("--spin")) : Map.of();
    List<ChainResult> results = new ArrayList<>();
    System.out.println(ChainResult.head());
    for (int round = 0; round < (int) number("--rounds"); round++) {
      for (Scenario scenario : scenarios()) {
        try (CommunicationManager manager = manager()) {
          ChainResult result =
              new Chain(scenario, manager.transport(), config, forAll)
                  .run(number("--warm-up"), number("--seconds"), round);
          if (round > 0 || number("--rounds") == 1) {
            results.add(result);
            System.out.println(result.row());
          }
        }
      }
    }
    if (!options.get("--json").isEmpty()) {
      Files.writeString(
          Path.of(options.get("--json")),
          results.stream().map(ChainResult::json).collect(Collectors.joining(",\n", "[\n", "\n]\n")));
    }
  }

  private static CommunicationManager manager() throws Exception {
    try (ServerSocket free = new ServerSocket(0)) {
      int port = free.getLocalPort();
      free.close();
      return CommunicationManager.start(
          Chain.SYSTEM,
          XmlConfiguration.inMemory(Chain.SYSTEM, Map.of("COMMUNICATION MANAGER PORT", port)),
          StandardTypes.registry(),
          System.out::println);
    }
  }

  public static void main(String[] args) throws Exception {
    if (Arrays.asList(args).contains("--help")) {
      System.out.print(HELP);
      return;
    }
    try {
      new ChainBenchmark(args).run();
      System.exit(0);
    } catch (Exception e) {
      e.printStackTrace();
      System.exit(1); // running services would keep the process alive
    }
  }
}
