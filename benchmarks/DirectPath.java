import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.mqtt.MqttClient;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Measures the way of a message from one service's thread to another's callback: on the direct path,
 * by MQTT through the embedded broker, and by MQTT through another broker whose port is given, also encrypted if a TLS
 * port and a file with its authority's certificate follow, by each of our clients; and on the direct path at
 * 400 Hz, where the receiver sleeps, or looks out for the time that SPIN says. The environment's U2SA_SPIN lists such times
 * [µs]: "0" for versions that do not know SPIN.
 */
public final class DirectPath {
  private static final Channel<StateInformation> CHANNEL =
      Channel.every("benchmark", StateInformation.TYPE);
  private static final com.sun.management.ThreadMXBean THREADS =
      (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final long PAUSE_NANOS = 200_000;
  private static final long PAUSE_AT_400_HZ_NANOS = 2_500_000;
  private static final int AT_400_HZ = 4_000;
  private static final String SPINS = System.getenv().getOrDefault("U2SA_SPIN", "0,50,3000");

  private DirectPath() {}

  /** Notes when each message came in; its x is its number. */
  private static final class Sink extends EventDrivenService {
    private final AtomicLong received = new AtomicLong();
    private volatile long[] cameNanos = new long[0];

    Sink(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Sink");
      registerSubscriber(CHANNEL);
    }

    @Override
    public void callback(U2SAData data) {
      long now = System.nanoTime();
      int number = (int) ((StateInformation) data).x().orElseThrow();
      long[] came = cameNanos;
      if (number < came.length) {
        came[number] = now;
      }
      received.incrementAndGet();
    }
  }

  /** Publishes from the benchmark's own thread. */
  private static final class Source extends EventDrivenService {
    Source(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Source");
      registerPublisher(CHANNEL);
    }

    void send(int number) {
      publish(CHANNEL, new StateInformation().sensorName("benchmark").x(number));
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  public static void main(String[] args) {
    Bench.runAndExit(() -> measureAll(args));
  }

  private static void measureAll(String[] args) throws Exception {
    Bench.printMachine("Way of a message");
    int port = Integer.parseInt(args[0]);
    try (CommunicationManager manager = Bench.manager(port)) {
      measure("direct path", manager.transport(), 20_000, 3_000_000, 100_000);
      for (String spin : SPINS.split(",")) {
        at400Hz(manager.transport(), Double.parseDouble(spin));
      }
      measure("MQTT, embedded broker", Bench.mqtt(port), 3_000, 30_000, 200);
    }
    if (args.length > 1) {
      measure("MQTT, Mosquitto", Bench.mqtt(Integer.parseInt(args[1])), 3_000, 30_000, 200);
    }
    if (args.length > 3) {
      for (MqttClient client : MqttClient.values()) {
        measure(
            "MQTT, Mosquitto, TLS, " + client,
            Bench.tls(Integer.parseInt(args[2]), args[3]).by(client),
            3_000,
            30_000,
            200);
      }
    }
  }

  private static ServiceContext context(Transport transport, Path logs, double spin) {
    return Bench.context(
        transport,
        logs,
        spin > 0.0
            ? Map.of("INBOX CAPACITY", 1_000_000, "SPIN", spin)
            : Map.of("INBOX CAPACITY", 1_000_000));
  }

  private static void at400Hz(Transport transport, double spin) throws Exception {
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    Sink sink = new Sink(context(transport, logs, spin));
    Source source = new Source(context(transport, logs, 0.0));
    sink.start();
    source.start();
    latency(source, sink, AT_400_HZ, PAUSE_NANOS); // warm-up
    long[] nanos = latency(source, sink, AT_400_HZ, PAUSE_AT_400_HZ_NANOS);
    System.out.printf(
        Locale.ROOT,
        "400 Hz, SPIN %-4.0f us     one way p50 %8.1f us, p99 %8.1f us%n",
        spin,
        nanos[nanos.length / 2] / 1e3,
        nanos[nanos.length * 99 / 100] / 1e3);
    source.kill();
    sink.kill();
  }

  /** Messages at once on the way are limited, so that what is measured is not a queue. */
  private static void measure(
      String way, Transport transport, int paced, int flood, int onTheWayAtMost) throws Exception {
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    Sink sink = new Sink(context(transport, logs, 0.0));
    Source source = new Source(context(transport, logs, 0.0));
    sink.start();
    source.start();
    flood(source, sink, flood / 4, onTheWayAtMost); // warm-up
    latency(source, sink, paced / 4, PAUSE_NANOS);
    long[] ids = {Thread.currentThread().getId(), sink.getId()};
    long[] before = THREADS.getThreadAllocatedBytes(ids);
    long[] cpuBefore = {THREADS.getThreadCpuTime(ids[0]), THREADS.getThreadCpuTime(ids[1])};
    double perSecond = flood(source, sink, flood, onTheWayAtMost);
    long[] cpuAfter = {THREADS.getThreadCpuTime(ids[0]), THREADS.getThreadCpuTime(ids[1])};
    long[] after = THREADS.getThreadAllocatedBytes(ids);
    long[] nanos = latency(source, sink, paced, PAUSE_NANOS);
    System.out.printf(
        Locale.ROOT,
        "%-22s one way p50 %8.1f us, p99 %8.1f us, %,12.0f messages/s;"
            + " a message takes %.0f ns of processor time of the source and %.0f ns of the sink,"
            + " %.0f B of the source, %.0f B of them to make it, and %.0f B of the sink%n",
        way,
        nanos[nanos.length / 2] / 1e3,
        nanos[nanos.length * 99 / 100] / 1e3,
        perSecond,
        (cpuAfter[0] - cpuBefore[0]) / (double) flood,
        (cpuAfter[1] - cpuBefore[1]) / (double) flood,
        (after[0] - before[0]) / (double) flood,
        bytesToMakeAMessage(),
        (after[1] - before[1]) / (double) flood);
    source.kill();
    sink.kill();
  }

  private static double bytesToMakeAMessage() {
    long id = Thread.currentThread().getId();
    int count = 10_000;
    StateInformation[] made = new StateInformation[count]; // so that none is optimised away
    long before = THREADS.getThreadAllocatedBytes(id);
    for (int i = 0; i < count; i++) {
      made[i] = new StateInformation().sensorName("benchmark").x(i);
      made[i].timestamp(1_000_000_000L + i);
    }
    return (THREADS.getThreadAllocatedBytes(id) - before) / (double) made.length;
  }

  private static long[] latency(Source source, Sink sink, int count, long pauseNanos) {
    long[] came = new long[count];
    long[] sent = new long[count];
    long before = sink.received.get();
    sink.cameNanos = came;
    for (int i = 0; i < count; i++) {
      sent[i] = System.nanoTime();
      source.send(i);
      LockSupport.parkNanos(pauseNanos);
    }
    awaitReceived(sink, before + count);
    sink.cameNanos = new long[0];
    long[] took = new long[count];
    Arrays.setAll(took, i -> came[i] - sent[i]);
    Arrays.sort(took);
    return took;
  }

  private static double flood(Source source, Sink sink, int count, int onTheWayAtMost) {
    long before = sink.received.get();
    long began = System.nanoTime();
    for (int i = 0; i < count; i++) {
      if (i % 64 == 0) {
        awaitReceived(sink, before + i - onTheWayAtMost);
      }
      source.send(i);
    }
    awaitReceived(sink, before + count);
    return count * 1e9 / (System.nanoTime() - began);
  }

  private static void awaitReceived(Sink sink, long count) {
    while (sink.received.get() < count) {
      LockSupport.parkNanos(20_000);
    }
  }
}
