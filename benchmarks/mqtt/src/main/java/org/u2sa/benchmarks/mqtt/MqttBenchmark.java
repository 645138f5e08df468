package org.u2sa.benchmarks.mqtt;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** Measures the ways in turn, round by round, so that all have the same load of the machine. */
public final class MqttBenchmark {
  private static final String HELP =
      """
      --ways A,B       %s
      --bytes 64,1024,65000     contents of a message (our texts end at 64 KiB)
      --rates 50,400,0 messages a second; 0: flat out
      --qos 0,1
      --processes one,two       sender, listener and broker in one JVM; or the listener in another
      --rounds 5       after one that warms up
      --seconds 1.0    of each measurement
      --window 200     messages on the way at most when flat out; 0: any number, a flood
      --limit 0        packets a second that our broker reads from a client; 0: its default
      --json FILE      each round's figures
      """
          .formatted(String.join(",", Ways.ALL));

  private final Map<String, String> options = new LinkedHashMap<>();
  private final List<Result> results = new ArrayList<>();
  private final Path progressFile = Files.createTempFile("u2sa-benchmark", "progress");
  private final Progress progress = new Progress(progressFile);
  private final Listener inside = new Listener(progressFile);

  private MqttBenchmark(String[] args) throws Exception {
    options.put("--ways", String.join(",", Ways.ALL));
    options.put("--bytes", "64,1024,65000");
    options.put("--rates", "50,400,0");
    options.put("--qos", "0,1");
    options.put("--processes", "one,two");
    options.put("--rounds", "5");
    options.put("--seconds", "1.0");
    options.put("--window", "200");
    options.put("--limit", "0");
    options.put("--json", "");
    options.put("--mosquitto", "0");
    options.put("--mosquitto-pid", "0");
    for (int i = 0; i < args.length; i += 2) {
      if (!options.containsKey(args[i]) || i + 1 == args.length) {
        throw new IllegalArgumentException(args[i] + ": expected\n" + HELP);
      }
      options.put(args[i], args[i + 1]);
    }
    for (String way : list("--ways")) {
      if (!Ways.ALL.contains(way)) {
        throw new IllegalArgumentException("way \"" + way + "\": expected one of " + Ways.ALL);
      }
    }
  }

  private List<String> list(String option) {
    return Arrays.asList(options.get(option).split(","));
  }

  private List<Integer> numbers(String option) {
    return list(option).stream().map(Integer::valueOf).collect(Collectors.toList());
  }

  private int number(String option) {
    return Integer.parseInt(options.get(option));
  }

  private void run() throws Exception {
    System.out.printf(
        Locale.ROOT,
        "%d cores, load average %.2f, Java %s%n",
        Runtime.getRuntime().availableProcessors(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"));
    try (Brokers brokers =
            new Brokers(
                number("--limit"),
                number("--mosquitto"),
                Long.parseLong(options.get("--mosquitto-pid")));
        ListenerProcess outside = new ListenerProcess(progressFile)) {
      for (int round = 0; round <= number("--rounds"); round++) {
        for (String processes : list("--processes")) {
          boolean two = processes.equals("two");
          for (int bytes : numbers("--bytes")) {
            for (int quality : numbers("--qos")) {
              for (String way : list("--ways")) {
                if (brokers.has(Ways.broker(way))) {
                  Ways.Load load = new Ways.Load(bytes, quality);
                  measure(brokers, two ? outside::obey : inside::obey, two, way, load, round);
                }
              }
            }
          }
        }
        System.err.println("round " + round + " done");
      }
    }
    System.out.print(Table.of(results));
    System.out.printf(
        Locale.ROOT,
        "load average at the end %.2f%n",
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
    if (!options.get("--json").isEmpty()) {
      Files.writeString(
          Path.of(options.get("--json")),
          results.stream().map(Result::json).collect(Collectors.joining(",\n", "[\n", "\n]\n")));
    }
    Files.delete(progressFile);
  }

  private void measure(
      Brokers brokers,
      Round.Orders listener,
      boolean two,
      String way,
      Ways.Load load,
      int round)
      throws Exception {
    boolean bare = Ways.broker(way).isEmpty();
    if (way.equals("handoff") && two || bare && load.quality() == 1) {
      return; // it has none
    }
    int port = brokers.port(Ways.broker(way));
    Way sender;
    if (way.equals("handoff")) {
      sender = new HandOff(inside);
      inside.open(sender);
    } else {
      listener.obey("open " + way + " " + port + " " + load.bytes() + " " + load.quality());
      sender = Ways.sending(way, port, load);
    }
    Round measuring = new Round(sender, listener, progress, brokers, two, number("--window"));
    for (int perS : numbers("--rates")) {
      double seconds = Double.parseDouble(options.get("--seconds"));
      Result result = measuring.measure(way, load, perS, round, seconds);
      if (round > 0) {
        results.add(result);
      }
    }
    listener.obey("close");
    if (!way.equals("handoff")) {
      sender.close();
    }
  }

  public static void main(String[] args) throws Exception {
    if (Arrays.asList(args).contains("--help")) {
      System.out.print(HELP);
      return;
    }
    new MqttBenchmark(args).run();
    System.exit(0);
  }
}
