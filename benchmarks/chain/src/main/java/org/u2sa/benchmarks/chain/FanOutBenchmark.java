package org.u2sa.benchmarks.chain;

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
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import org.HdrHistogram.Histogram;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.service.ServiceContext;

/**
 * One publisher and many subscribers, on the direct path and by MQTT through the embedded broker, in turn; and a flood
 * into an inbox of the default size, of which each message must be handled or counted as lost.
 */
public final class FanOutBenchmark {
  private static final String SYSTEM = "fanout";
  private static final Channel<StateInformation> CHANNEL = Channel.every("fan-out", StateInformation.TYPE);
  private static final long QUIET_NANOS = 2_000_000_000L; // without another message all are there
  private static final double MICRO = 1e3;

  private final Map<String, String> options = new LinkedHashMap<>();
  private final List<String> json = new ArrayList<>();
  private final SystemClock clock = new SystemClock();
  private final Path logs = Files.createTempDirectory("u2sa-benchmark");
  private final int port = freePort();

  private FanOutBenchmark(String[] args) throws Exception {
    options.put("--subscribers", "1,10,100");
    options.put("--ways", "direct,mqtt");
    options.put("--hz", "50");
    options.put("--seconds", "5");
    options.put("--rounds", "2"); // the first warms up, and is not counted
    options.put("--flood", "100000");
    options.put("--json", "");
    for (int i = 0; i < args.length; i += 2) {
      if (!options.containsKey(args[i]) || i + 1 == args.length) {
        throw new IllegalArgumentException(args[i] + ": expected one of " + options.keySet() + " and a value");
      }
      options.put(args[i], args[i + 1]);
    }
  }

  private static int freePort() throws Exception {
    try (ServerSocket free = new ServerSocket(0)) {
      return free.getLocalPort();
    }
  }

  private void run() throws Exception {
    System.out.printf(
        Locale.ROOT,
        "fan-out, %d cores, load average %.2f, Java %s%n",
        Runtime.getRuntime().availableProcessors(),
        load(),
        System.getProperty("java.version"));
    try (CommunicationManager manager =
        CommunicationManager.start(
            SYSTEM,
            XmlConfiguration.inMemory(SYSTEM, Map.of("COMMUNICATION MANAGER PORT", port)),
            StandardTypes.registry(),
            System.out::println)) {
      for (int round = 0; round < number("--rounds"); round++) {
        boolean counts = round > 0 || number("--rounds") == 1;
        for (String subscribers : options.get("--subscribers").split(",")) {
          for (String way : options.get("--ways").split(",")) {
            fanOut(way, transport(way, manager), Integer.parseInt(subscribers), counts);
          }
        }
        for (String way : options.get("--ways").split(",")) {
          flood(way, transport(way, manager), counts);
        }
      }
    }
    if (!options.get("--json").isEmpty()) {
      Files.writeString(
          Path.of(options.get("--json")), json.stream().collect(Collectors.joining(",\n", "[\n", "\n]\n")));
    }
  }

  private int number(String option) {
    return Integer.parseInt(options.get(option));
  }

  private static double load() {
    return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
  }

  private Transport transport(String way, CommunicationManager manager) {
    return way.equals("direct")
        ? manager.transport()
        : new MqttTransport("127.0.0.1", port, SYSTEM, new MessageCodec(StandardTypes.registry()));
  }

  private ServiceContext context(Transport transport, String name) {
    return ServiceContext.of(SYSTEM, XmlConfiguration.inMemory(name, Map.of("SERVICE NAME", name)))
        .clock(clock)
        .transport(transport)
        .logDirectory(logs)
        .build();
  }

  private void fanOut(String way, Transport transport, int subscribers, boolean counts) {
    long periodNanos = 1_000_000_000L / number("--hz");
    List<Ear> ears = new ArrayList<>();
    for (int i = 0; i < subscribers; i++) {
      ears.add(new Ear(context(transport, "Ear" + i), CHANNEL, periodNanos));
      ears.get(i).start();
    }
    Voice voice = new Voice(context(transport, "Voice"), CHANNEL);
    voice.start();
    int count = number("--hz") * number("--seconds");
    long due = System.nanoTime() + periodNanos;
    for (int i = 0; i < count; i++, due += periodNanos) {
      while (System.nanoTime() < due) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      voice.say(System.nanoTime());
    }
    awaitQuiet(ears);
    Histogram all = new Histogram(60_000_000_000L, 3);
    ears.forEach(ear -> all.add(ear.took()));
    long lost = (long) count * subscribers - ears.stream().mapToLong(Ear::heard).sum();
    voice.kill();
    ears.forEach(Ear::kill);
    if (counts) {
      double p50 = all.getValueAtPercentile(50) / MICRO;
      double p99 = all.getValueAtPercentile(99) / MICRO;
      System.out.printf(
          Locale.ROOT,
          "fan-out %-6s %3d subscribers %3d Hz: p50 %8.0f us, p99 %8.0f us, max %8.0f us, lost %d, load %.1f%n",
          way, subscribers, number("--hz"), p50, p99, all.getMaxValue() / MICRO, lost, load());
      json.add(
          String.format(
              Locale.ROOT,
              "{\"benchmark\": \"fan-out\", \"way\": \"%s\", \"subscribers\": %d, \"hz\": %d, \"p50_us\": %.1f,"
                  + " \"p99_us\": %.1f, \"max_us\": %.1f, \"lost\": %d, \"load\": %.2f}",
              way, subscribers, number("--hz"), p50, p99, all.getMaxValue() / MICRO, lost, load()));
    }
  }

  private static void awaitQuiet(List<Ear> ears) {
    long seen = -1;
    long since = System.nanoTime();
    while (System.nanoTime() - since < QUIET_NANOS) {
      long heard = ears.stream().mapToLong(Ear::heard).sum();
      if (heard != seen) {
        seen = heard;
        since = System.nanoTime();
      }
      LockSupport.parkNanos(20_000_000);
    }
  }

  private void flood(String way, Transport transport, boolean counts) throws Exception {
    HealthWatch watch = new HealthWatch(context(transport, "HealthWatch"));
    watch.start();
    Ear ear = new Ear(context(transport, "Ear"), CHANNEL, 0);
    ear.start();
    Voice voice = new Voice(context(transport, "Voice"), CHANNEL);
    voice.start();
    int sent = number("--flood");
    long refused = 0;
    long began = System.nanoTime();
    for (int i = 0; i < sent; i++) {
      if (!voice.say(0)) {
        refused++;
      }
    }
    double seconds = (System.nanoTime() - began) / 1e9;
    awaitQuiet(List.of(ear));
    long dropped = watch.sum(HealthReport::dropped);
    long missed = watch.sum(report -> report.missed().orElse(0L));
    long onTheWay = sent - ear.heard() - refused - dropped;
    // What the publisher was refused has a number too, and so the receiver counts most of it as missed.
    long uncounted = Math.max(0, onTheWay - Math.max(0, missed - refused));
    voice.kill();
    ear.kill();
    watch.kill();
    if (counts) {
      System.out.printf(
          Locale.ROOT,
          "flood   %-6s %d messages in %.2f s: handled %d, dropped by the inbox %d, refused to the publisher %d,"
              + " missed by the receiver %d, lost uncounted %d, load %.1f%n",
          way, sent, seconds, ear.heard(), dropped, refused, missed, uncounted, load());
      json.add(
          String.format(
              Locale.ROOT,
              "{\"benchmark\": \"flood\", \"way\": \"%s\", \"sent\": %d, \"seconds\": %.3f, \"handled\": %d, \"dropped\": %d,"
                  + " \"refused\": %d, \"missed\": %d, \"uncounted\": %d, \"load\": %.2f}",
              way, sent, seconds, ear.heard(), dropped, refused, missed, uncounted, load()));
    }
  }

  public static void main(String[] args) throws Exception {
    if (Arrays.asList(args).contains("--help")) {
      System.out.println("--subscribers 1,10,100 --ways direct,mqtt --hz 50 --seconds 5 --rounds 2 --flood 100000 --json FILE");
      return;
    }
    try {
      new FanOutBenchmark(args).run();
      System.exit(0);
    } catch (Exception e) {
      e.printStackTrace();
      System.exit(1); // running services would keep the process alive
    }
  }
}
