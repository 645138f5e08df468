import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.Actuator;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * What clients that flood the embedded broker (flood.py) cost a vehicle: its control loop on the direct path, 50 Hz messages and emergency
 * stops of other MQTT clients. Arguments: the port, flood.py, then variables of the Communication Manager, such as "CLIENT MESSAGES PER SECOND=1000".
 */
public final class FloodedVehicle {
  private static final int HZ = 50;
  private static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(1) / HZ;
  private static final int SLOTS = 1_000; // messages that are told apart, 20 s
  private static final double SECONDS = 6.0;
  private static final Channel<StateInformation> PROBE = Channel.every("probe", StateInformation.TYPE);

  private static final List<Long> STEPS = list();
  private static final List<Long> CHAIN = list();
  private static final List<Long> MQTT = list();
  private static final List<Long> STOPS = list();
  private static final List<Long> DIRECT_STOPS = list();
  private static volatile boolean ends;

  private FloodedVehicle() {}

  private static List<Long> list() {
    return Collections.synchronizedList(new ArrayList<>());
  }

  /** Turns the newest state of its own sensor into a command; its steps are watched. */
  private static final class Control extends PeriodicService {
    private long before;

    Control(ServiceContext context) {
      super(context, ServiceRole.CONTROL_SYSTEM, "Control", HZ);
      registerSubscriber(Channels.STATE);
      registerPublisher(Channels.ACTUATION);
    }

    @Override
    public void callback(U2SAData data) {
      StateInformation state = (StateInformation) data;
      if (state.sensorName().equals("own")) {
        publish(Channels.ACTUATION, PercentageCommand.of("Servo", state.x().orElseThrow()));
      }
    }

    @Override
    protected void step(double nowS) {
      long now = System.nanoTime();
      if (before != 0) {
        STEPS.add(Math.max(0, now - before - PERIOD_NANOS));
      }
      before = now;
    }
  }

  /** Notes when it obeys and when it goes neutral. */
  private static final class Servo extends Actuator {
    private final long[] sentNanos = new long[SLOTS];
    private volatile CountDownLatch stands = new CountDownLatch(1);
    private volatile CountDownLatch moves = new CountDownLatch(1);

    Servo(ServiceContext context) {
      super(context, "Servo");
    }

    @Override
    protected void actuate(double percentage) {
      moves.countDown();
      CHAIN.add(System.nanoTime() - sentNanos[(int) Math.round(percentage * 10.0)]);
    }

    @Override
    protected void neutral() {
      stands.countDown();
    }
  }

  public static void main(String[] args) {
    Bench.runAndExit(() -> measureAll(args));
  }

  private static void measureAll(String[] args) throws Exception {
    Bench.printMachine("Flooded vehicle");
    int port = Integer.parseInt(args[0]);
    Map<String, Object> variables = new TreeMap<>(Map.of("COMMUNICATION MANAGER PORT", port));
    for (int i = 2; i < args.length; i++) {
      String[] parts = args[i].split("=");
      variables.put(parts[0], parts[1].matches("\\d+") ? Integer.valueOf(parts[1]) : parts[1]);
    }
    System.out.println(variables);
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    try (CommunicationManager manager =
        CommunicationManager.start(
            "benchmark", XmlConfiguration.inMemory("benchmark", variables), StandardTypes.registry(), System.out::println)) {
      Transport direct = manager.transport();
      Control control = new Control(Bench.context(direct, logs, Map.of()));
      Servo servo = new Servo(Bench.actuator(direct, logs, "Servo"));
      control.start();
      servo.start();
      start("sensor", () -> sense(direct, servo));
      start("probe", () -> probe(port));
      start("stops", () -> stops(direct, port, servo));
      List<String> scenarios = new ArrayList<>(List.of("0 small 0", "0 small 0"));
      String chosen = System.getenv("U2SA_FLOODS"); // such as "8 small 0,1 large 1"
      if (chosen == null) {
        for (String kind : List.of("small 0", "small 1", "large 0", "large 1", "sources 0", "unheard 0")) {
          for (int clients : new int[] {1, 2, 8}) {
            scenarios.add(clients + " " + kind);
          }
        }
      } else {
        scenarios.addAll(List.of(chosen.split(",")));
      }
      for (String scenario : scenarios) {
        measure(scenario.split(" "), port, args[1]);
      }
      ends = true;
    }
  }

  private interface Work {
    void run() throws Exception;
  }

  private static void start(String name, Work work) {
    Thread thread =
        new Thread(
            () -> {
              try {
                work.run();
              } catch (Exception e) {
                e.printStackTrace();
              }
            },
            name);
    thread.setDaemon(true);
    thread.start();
  }

  private static void sense(Transport direct, Servo servo) {
    Connection sensor = Bench.operator(direct);
    long due = System.nanoTime();
    for (int n = 0; !ends; n++) {
      due = await(due);
      servo.sentNanos[n % SLOTS] = System.nanoTime();
      Bench.send(sensor, Channels.STATE, new StateInformation().sensorName("own").x(n % SLOTS / 10.0));
    }
  }

  private static long await(long due) {
    for (long left = due - System.nanoTime(); left > 0; left = due - System.nanoTime()) {
      LockSupport.parkNanos(left);
    }
    return Math.max(due, System.nanoTime() - PERIOD_NANOS) + PERIOD_NANOS;
  }

  private static void probe(int port) {
    long[] sentNanos = new long[SLOTS];
    Connection listener = Bench.mqtt(port).connect("Listener", new Listener(sentNanos));
    listener.subscribe(PROBE);
    Connection speaker = Bench.mqtt(port).connect("Speaker", new Listener(sentNanos));
    long due = System.nanoTime();
    for (int n = 0; !ends; n++) {
      due = await(due);
      sentNanos[n % SLOTS] = System.nanoTime();
      Bench.send(speaker, PROBE, new StateInformation().sensorName("probe").x(n % SLOTS));
    }
  }

  private record Listener(long[] sentNanos) implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      MQTT.add(System.nanoTime() - sentNanos[(int) ((StateInformation) message).x().orElseThrow()]);
    }

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }

  private static void stops(Transport direct, int port, Servo servo) throws InterruptedException {
    Connection near = direct.connect("Button", new Listener(new long[SLOTS]));
    Connection far = Bench.operator(Bench.mqtt(port));
    for (boolean isFar = true; !ends; isFar = !isFar) {
      servo.stands = new CountDownLatch(1);
      long told = System.nanoTime();
      Connection by = isFar ? far : near;
      EmergencyStop stop = Bench.send(by, Channels.EMERGENCY_STOP, new EmergencyStop().active(true).operator("Ann"));
      if (!servo.stands.await(30, TimeUnit.SECONDS)) {
        System.out.println("NOT STOPPED within 30 s");
      }
      (isFar ? STOPS : DIRECT_STOPS).add(System.nanoTime() - told);
      servo.moves = new CountDownLatch(1);
      Bench.send(
          by, Channels.EMERGENCY_STOP, new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()).operator("Ann"));
      servo.moves.await(30, TimeUnit.SECONDS); // only then is the next stop one
      TimeUnit.MILLISECONDS.sleep(150);
    }
  }

  private static void measure(String[] scenario, int port, String flood) throws Exception {
    boolean isFlood = !scenario[0].equals("0");
    Process process =
        isFlood
            ? new ProcessBuilder("python3", flood, "" + port, scenario[0], scenario[1], scenario[2], "" + SECONDS)
                .redirectErrorStream(true)
                .start()
            : null;
    TimeUnit.MILLISECONDS.sleep(700);
    List<List<Long>> all = List.of(STEPS, CHAIN, MQTT, STOPS, DIRECT_STOPS);
    all.forEach(List::clear);
    long began = System.nanoTime();
    var os = (com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    long cpu = os.getProcessCpuTime();
    long heap = 0;
    while (System.nanoTime() - began < 4.8e9) {
      TimeUnit.MILLISECONDS.sleep(50);
      heap = Math.max(heap, ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed());
    }
    double took = (System.nanoTime() - began) / 1e9;
    String figures =
        String.format(
            Locale.ROOT,
            "%-11s step late %s | chain %s | MQTT %s | stop MQTT %s | stop direct %s | cpu %.2f heap %d MB rss %d MB",
            String.join(" ", scenario),
            shown(STEPS),
            shown(CHAIN),
            shown(MQTT),
            shown(STOPS),
            shown(DIRECT_STOPS),
            (os.getProcessCpuTime() - cpu) / 1e9 / took,
            heap >> 20,
            residentMb());
    if (isFlood) {
      try (BufferedReader said = new BufferedReader(new InputStreamReader(process.getInputStream()))) {
        figures += " | " + said.readLine();
      }
      process.waitFor();
    }
    System.out.println(figures);
  }

  private static long residentMb() throws IOException {
    for (String line : Files.readAllLines(Path.of("/proc/self/status"))) {
      if (line.startsWith("VmRSS")) {
        return Long.parseLong(line.replaceAll("\\D", "")) >> 10;
      }
    }
    return 0;
  }

  private static String shown(List<Long> nanos) {
    List<Long> sorted = new ArrayList<>(List.of(nanos.toArray(new Long[0])));
    Collections.sort(sorted);
    int n = sorted.size();
    return n == 0
        ? "none"
        : String.format(
            Locale.ROOT,
            "%.2f/%.2f/%.2f (%d)",
            sorted.get(n / 2) / 1e6,
            sorted.get((int) (0.99 * (n - 1))) / 1e6,
            sorted.get(n - 1) / 1e6,
            n);
  }
}
