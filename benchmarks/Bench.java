import org.u2sa.messages.registry.StandardTypes;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ServiceContext;

/** What the benchmarks share: the machine they state, the system they build, and the operator who commands it. */
final class Bench {
  private static final String SYSTEM = "benchmark";
  private static final SystemClock CLOCK = new SystemClock(); // one: emergency stops of one time are one stop

  private Bench() {}

  interface Measurements {
    void run() throws Exception;
  }

  /** Ends the program when all is measured: services that still run after a failure would keep it alive. */
  static void runAndExit(Measurements measurements) {
    try {
      measurements.run();
      System.exit(0);
    } catch (Exception e) {
      e.printStackTrace();
      System.exit(1);
    }
  }

  static void printMachine(String what) {
    System.out.printf(
        Locale.ROOT,
        "%s, %d cores, load average %.2f, Java %s%n",
        what,
        Runtime.getRuntime().availableProcessors(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"));
  }

  /** Prints how long stops took; the times are sorted. */
  static void printStops(String what, long[] nanos) {
    System.out.printf(
        Locale.ROOT,
        "%s p50 %8.2f ms, p99 %8.2f ms, max %8.2f ms (%d stops)%n",
        what,
        nanos[nanos.length / 2] / 1e6,
        nanos[nanos.length * 99 / 100] / 1e6,
        nanos[nanos.length - 1] / 1e6,
        nanos.length);
  }

  static CommunicationManager manager(int port) {
    return CommunicationManager.start(
        SYSTEM,
        XmlConfiguration.inMemory(SYSTEM, Map.of("COMMUNICATION MANAGER PORT", port)),
        StandardTypes.registry(),
        System.out::println);
  }

  static Transport mqtt(int port) {
    return new MqttTransport("127.0.0.1", port, SYSTEM, new MessageCodec(StandardTypes.registry()));
  }

  static MqttTransport tls(int port, String authority) {
    return new MqttTransport(
        "localhost",
        port,
        SYSTEM,
        new MessageCodec(StandardTypes.registry()),
        BrokerAccess.of("", "", true, authority));
  }

  static ServiceContext context(Transport transport, Path logs, Map<String, Object> variables) {
    return ServiceContext.of(SYSTEM, XmlConfiguration.inMemory(SYSTEM, variables))
        .clock(CLOCK)
        .transport(transport)
        .logDirectory(logs)
        .build();
  }

  /** An actuator's context: what it is told holds until something else is. */
  static ServiceContext actuator(Transport transport, Path logs, String name) {
    return context(transport, logs, Map.of("SERVICE NAME", name, "COMMAND EXPIRY", 60.0));
  }

  /** Who commands and subscribes to nothing. */
  static Connection operator(Transport transport) {
    return transport.connect("Operator", new Deaf());
  }

  static <T extends U2SAData> T send(Connection operator, Channel<? super T> channel, T message) {
    message.systemId(SYSTEM);
    message.timestamp(CLOCK.micros());
    message.freeze();
    operator.publish(channel, message);
    return message;
  }

  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {}

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }
}
