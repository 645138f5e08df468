import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.SystemClock;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.StopCommand;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/**
 * Measures the time from a stop command to the last actuator's {@code neutral()}: of one actuator by name, and of
 * eight at once, on the direct path and by MQTT. The actuators move when the command comes.
 */
public final class StopLatency {
  private static final int ACTUATORS = 8;
  private static final long ALL_WITHIN_S = 30;

  private StopLatency() {}

  /** Notes when it went neutral at its end. */
  private static final class Servo extends Actuator {
    private final CountDownLatch moves;
    private final CountDownLatch ended;
    private volatile long neutralNanos;

    Servo(ServiceContext context, CountDownLatch moves, CountDownLatch ended) {
      super(context, "Servo");
      this.moves = moves;
      this.ended = ended;
    }

    @Override
    protected void actuate(double percentage) {
      moves.countDown();
    }

    @Override
    protected void neutral() {
      neutralNanos = System.nanoTime();
    }

    @Override
    protected void close() {
      ended.countDown(); // after neutral, as the base class has it
    }
  }

  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {}

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }

  public static void main(String[] args) {
    try {
      measureAll(args);
      System.exit(0);
    } catch (Exception e) {
      e.printStackTrace();
      System.exit(1); // services that still run would keep the program alive
    }
  }

  private static void measureAll(String[] args) throws Exception {
    System.out.printf(
        Locale.ROOT,
        "Stop, %d cores, load average %.2f, Java %s%n",
        Runtime.getRuntime().availableProcessors(),
        java.lang.management.ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"));
    int port = Integer.parseInt(args[0]);
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    try (CommunicationManager manager =
        CommunicationManager.start(
            "benchmark",
            XmlConfiguration.inMemory("benchmark", Map.of("COMMUNICATION MANAGER PORT", port)),
            MessageTypes.standard(),
            System.out::println)) {
      measure("direct path", manager.transport(), logs, 300);
      if (args.length > 1) {
        measure("MQTT, Mosquitto", mqtt(Integer.parseInt(args[1])), logs, 30);
      }
      measure("MQTT, embedded broker", mqtt(port), logs, 30);
    }
  }

  private static Transport mqtt(int port) {
    return new MqttTransport(
        "127.0.0.1", port, "benchmark", new MessageCodec(MessageTypes.standard()));
  }

  private static void measure(String way, Transport transport, Path logs, int runs)
      throws Exception {
    try (Connection operator = transport.connect("Operator", new Deaf())) {
      for (boolean all : new boolean[] {false, true}) {
        for (int i = 0; i < runs / 10; i++) { // warm-up
          stop(transport, operator, logs, all);
        }
        long[] nanos = new long[runs];
        for (int i = 0; i < runs; i++) {
          nanos[i] = stop(transport, operator, logs, all);
        }
        Arrays.sort(nanos);
        System.out.printf(
            Locale.ROOT,
            "%-22s %-14s command to last neutral p50 %8.2f ms, p99 %8.2f ms, max %8.2f ms (%d stops)%n",
            way,
            all ? "all " + ACTUATORS : "one by name",
            nanos[runs / 2] / 1e6,
            nanos[runs * 99 / 100] / 1e6,
            nanos[runs - 1] / 1e6,
            runs);
      }
    }
  }

  /** Time from the command to the last of those that it concerns being neutral [ns]. */
  private static long stop(Transport transport, Connection operator, Path logs, boolean all)
      throws Exception {
    CountDownLatch moves = new CountDownLatch(ACTUATORS);
    CountDownLatch ended = new CountDownLatch(all ? ACTUATORS : 1);
    List<Servo> servos = new ArrayList<>();
    for (int i = 0; i < ACTUATORS; i++) {
      servos.add(new Servo(context(transport, logs, "Servo" + i), moves, ended));
      servos.get(i).start();
    }
    for (Servo servo : servos) {
      send(operator, Channels.ACTUATION, PercentageCommand.of(servo.getServiceName(), 50.0));
    }
    await(moves);
    StopCommand command = new StopCommand().stopAll(all);
    if (!all) {
      command.serviceName("Servo0");
    }
    long told = System.nanoTime();
    send(operator, Channels.STOP, command);
    await(ended);
    long last = told;
    for (Servo servo : all ? servos : servos.subList(0, 1)) {
      last = Math.max(last, servo.neutralNanos);
    }
    servos.forEach(Servo::kill);
    return last - told;
  }

  private static void send(Connection operator, Channel<?> channel, U2SAData message) {
    message.systemId("benchmark");
    message.timestamp(new SystemClock().micros());
    message.freeze();
    operator.publish(channel, message);
  }

  private static void await(CountDownLatch latch) throws InterruptedException {
    if (!latch.await(ALL_WITHIN_S, TimeUnit.SECONDS)) {
      throw new IllegalStateException("not within " + ALL_WITHIN_S + " s");
    }
  }

  private static ServiceContext context(Transport transport, Path logs, String name) {
    return ServiceContext.of(
            "benchmark",
            XmlConfiguration.inMemory(
                "benchmark", Map.of("SERVICE NAME", name, "COMMAND EXPIRY", 60.0)))
        .clock(new SystemClock())
        .transport(transport)
        .logDirectory(logs)
        .build();
  }
}
