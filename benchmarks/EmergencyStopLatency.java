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
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/**
 * Measures the time from an emergency stop to the last {@code neutral()} of eight actuators that move, on the direct
 * path and by MQTT. The actuators stay: each stop is cleared, and they are commanded until they move again.
 */
public final class EmergencyStopLatency {
  private static final SystemClock CLOCK = new SystemClock(); // one: stops of one time are one stop
  private static final String SYSTEM = "benchmark";
  private static final int ACTUATORS = 8;
  private static final long WITHIN_S = 30;

  private EmergencyStopLatency() {}

  /** Notes when it moves and when it goes neutral. */
  private static final class Servo extends Actuator {
    private volatile CountDownLatch moves = new CountDownLatch(1);
    private volatile CountDownLatch stands = new CountDownLatch(1);
    private volatile long neutralNanos;

    Servo(ServiceContext context) {
      super(context, "Servo");
    }

    @Override
    protected void actuate(double percentage) {
      moves.countDown();
    }

    @Override
    protected void neutral() {
      neutralNanos = System.nanoTime();
      stands.countDown();
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
        "Emergency stop, %d cores, load average %.2f, Java %s%n",
        Runtime.getRuntime().availableProcessors(),
        java.lang.management.ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"));
    int port = Integer.parseInt(args[0]);
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    try (CommunicationManager manager =
        CommunicationManager.start(
            SYSTEM,
            XmlConfiguration.inMemory(SYSTEM, Map.of("COMMUNICATION MANAGER PORT", port)),
            MessageTypes.standard(),
            System.out::println)) {
      measure("direct path", manager.transport(), logs, 1000);
      measure("MQTT, embedded broker", mqtt(port), logs, 300);
      if (args.length > 1) {
        measure("MQTT, Mosquitto", mqtt(Integer.parseInt(args[1])), logs, 300);
      }
    }
  }

  private static Transport mqtt(int port) {
    return new MqttTransport("127.0.0.1", port, SYSTEM, new MessageCodec(MessageTypes.standard()));
  }

  private static void measure(String way, Transport transport, Path logs, int runs)
      throws Exception {
    List<Servo> servos = new ArrayList<>();
    for (int i = 0; i < ACTUATORS; i++) {
      servos.add(new Servo(context(transport, logs, "Servo" + i)));
      servos.get(i).start();
    }
    try (Connection operator = transport.connect("Operator", new Deaf())) {
      for (int i = 0; i < runs / 10; i++) { // warm-up
        stop(operator, servos);
      }
      long[] nanos = new long[runs];
      for (int i = 0; i < runs; i++) {
        nanos[i] = stop(operator, servos);
      }
      Arrays.sort(nanos);
      System.out.printf(
          Locale.ROOT,
          "%-22s stop to last of %d neutral p50 %7.2f ms, p99 %7.2f ms, max %7.2f ms (%d stops)%n",
          way,
          ACTUATORS,
          nanos[runs / 2] / 1e6,
          nanos[runs * 99 / 100] / 1e6,
          nanos[runs - 1] / 1e6,
          runs);
    } finally {
      servos.forEach(Servo::kill);
    }
  }

  /** Time from the stop until the last actuator is neutral [ns]; leaves it cleared. */
  private static long stop(Connection operator, List<Servo> servos) throws Exception {
    for (Servo servo : servos) {
      servo.moves = new CountDownLatch(1);
    }
    for (Servo servo : servos) {
      long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(WITHIN_S);
      do {
        send(operator, Channels.ACTUATION, PercentageCommand.of(servo.getServiceName(), 50.0));
      } while (!servo.moves.await(20, TimeUnit.MILLISECONDS) && System.nanoTime() < until);
      servo.stands = new CountDownLatch(1);
    }
    long told = System.nanoTime();
    EmergencyStop stop =
        send(operator, Channels.EMERGENCY_STOP, new EmergencyStop().active(true).operator("Ann"));
    long last = told;
    for (Servo servo : servos) {
      if (!servo.stands.await(WITHIN_S, TimeUnit.SECONDS)) {
        throw new IllegalStateException(servo.getServiceName() + " moves " + WITHIN_S + " s later");
      }
      last = Math.max(last, servo.neutralNanos);
    }
    send(
        operator,
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()).operator("Ann"));
    return last - told;
  }

  private static <T extends U2SAData> T send(Connection operator, Channel<? super T> channel, T message) {
    message.systemId(SYSTEM);
    message.timestamp(CLOCK.micros());
    message.freeze();
    operator.publish(channel, message);
    return message;
  }

  private static ServiceContext context(Transport transport, Path logs, String name) {
    return ServiceContext.of(
            SYSTEM,
            XmlConfiguration.inMemory(SYSTEM, Map.of("SERVICE NAME", name, "COMMAND EXPIRY", 60.0)))
        .clock(CLOCK)
        .transport(transport)
        .logDirectory(logs)
        .build();
  }
}
