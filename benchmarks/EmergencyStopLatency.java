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
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/**
 * Measures the time from an emergency stop to the last {@code neutral()} of eight actuators that move, on the direct
 * path and by MQTT. The actuators stay: each stop is cleared, and they are commanded until they move again.
 */
public final class EmergencyStopLatency {
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

  public static void main(String[] args) {
    Bench.runAndExit(() -> measureAll(args));
  }

  private static void measureAll(String[] args) throws Exception {
    Bench.printMachine("Emergency stop");
    int port = Integer.parseInt(args[0]);
    Path logs = Files.createTempDirectory("u2sa-benchmark");
    try (CommunicationManager manager = Bench.manager(port)) {
      measure("direct path", manager.transport(), logs, 1000);
      measure("MQTT, embedded broker", Bench.mqtt(port), logs, 300);
      if (args.length > 1) {
        measure("MQTT, Mosquitto", Bench.mqtt(Integer.parseInt(args[1])), logs, 300);
      }
    }
  }

  private static void measure(String way, Transport transport, Path logs, int runs)
      throws Exception {
    List<Servo> servos = new ArrayList<>();
    for (int i = 0; i < ACTUATORS; i++) {
      servos.add(new Servo(Bench.actuator(transport, logs, "Servo" + i)));
      servos.get(i).start();
    }
    try (Connection operator = Bench.operator(transport)) {
      for (int i = 0; i < runs / 10; i++) { // warm-up
        stop(operator, servos);
      }
      long[] nanos = new long[runs];
      for (int i = 0; i < runs; i++) {
        nanos[i] = stop(operator, servos);
      }
      Arrays.sort(nanos);
      Bench.printStops(
          String.format(Locale.ROOT, "%-22s stop to last of %d neutral", way, ACTUATORS), nanos);
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
        Bench.send(operator, Channels.ACTUATION, PercentageCommand.of(servo.getServiceName(), 50.0));
      } while (!servo.moves.await(20, TimeUnit.MILLISECONDS) && System.nanoTime() < until);
      servo.stands = new CountDownLatch(1);
    }
    long told = System.nanoTime();
    EmergencyStop stop =
        Bench.send(operator, Channels.EMERGENCY_STOP, new EmergencyStop().active(true).operator("Ann"));
    long last = told;
    for (Servo servo : servos) {
      if (!servo.stands.await(WITHIN_S, TimeUnit.SECONDS)) {
        throw new IllegalStateException(servo.getServiceName() + " moves " + WITHIN_S + " s later");
      }
      last = Math.max(last, servo.neutralNanos);
    }
    Bench.send(
        operator,
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()).operator("Ann"));
    return last - told;
  }
}
