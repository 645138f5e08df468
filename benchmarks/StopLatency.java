import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.safety.StopCommand;
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

  public static void main(String[] args) {
    Bench.runAndExit(() -> measureAll(args));
  }

  private static void measureAll(String[] args) throws Exception {
    Bench.printMachine("Stop");
    int port = Integer.parseInt(args[0]);
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    try (CommunicationManager manager = Bench.manager(port)) {
      measure("direct path", manager.transport(), logs, 300);
      if (args.length > 1) {
        measure("MQTT, Mosquitto", Bench.mqtt(Integer.parseInt(args[1])), logs, 30);
      }
      measure("MQTT, embedded broker", Bench.mqtt(port), logs, 30);
    }
  }

  private static void measure(String way, Transport transport, Path logs, int runs)
      throws Exception {
    try (Connection operator = Bench.operator(transport)) {
      for (boolean all : new boolean[] {false, true}) {
        for (int i = 0; i < runs / 10; i++) { // warm-up
          stop(transport, operator, logs, all);
        }
        long[] nanos = new long[runs];
        for (int i = 0; i < runs; i++) {
          nanos[i] = stop(transport, operator, logs, all);
        }
        Arrays.sort(nanos);
        String told = all ? "all " + ACTUATORS : "one by name";
        Bench.printStops(
            String.format(Locale.ROOT, "%-22s %-14s command to last neutral", way, told), nanos);
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
      servos.add(new Servo(Bench.actuator(transport, logs, "Servo" + i), moves, ended));
      servos.get(i).start();
    }
    for (Servo servo : servos) {
      Bench.send(operator, Channels.ACTUATION, PercentageCommand.of(servo.getServiceName(), 50.0));
    }
    await(moves);
    StopCommand command = new StopCommand().stopAll(all);
    if (!all) {
      command.serviceName("Servo0");
    }
    long told = System.nanoTime();
    Bench.send(operator, Channels.STOP, command);
    await(ended);
    long last = told;
    for (Servo servo : all ? servos : servos.subList(0, 1)) {
      last = Math.max(last, servo.neutralNanos);
    }
    servos.forEach(Servo::kill);
    return last - told;
  }

  private static void await(CountDownLatch latch) throws InterruptedException {
    if (!latch.await(ALL_WITHIN_S, TimeUnit.SECONDS)) {
      throw new IllegalStateException("not within " + ALL_WITHIN_S + " s");
    }
  }
}
