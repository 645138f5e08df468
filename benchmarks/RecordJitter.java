import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.Recorder;
import org.u2sa.service.ServiceContext;

/**
 * What a recorder costs a control loop of 100 Hz that publishes a state and eight commands a step: how late its steps begin, and how long
 * they take, with a recorder on the bus and without, in turn. Argument: the recording's folder.
 */
public final class RecordJitter {
  private static final int ROUNDS = 4;
  private static final int STEPS = 1_000;
  private static final int COMMANDS = 8;
  private static final long PERIOD_NANOS = 10_000_000;

  private RecordJitter() {}

  public static void main(String[] args) throws Exception {
    Path folder =
        args.length > 0 && Files.isDirectory(Path.of(args[0])) ? Path.of(args[0]) : Files.createTempDirectory("jitter");
    long[][] late = new long[2][ROUNDS * STEPS];
    long[][] took = new long[2][ROUNDS * STEPS];
    run(folder, true, new long[STEPS], new long[STEPS], 0); // the virtual machine warms up
    for (int round = 0; round < ROUNDS; round++) {
      for (int with = 0; with < 2; with++) {
        run(folder, with == 1, late[with], took[with], round * STEPS);
      }
    }
    for (int with = 0; with < 2; with++) {
      System.out.printf(
          Locale.ROOT,
          "%s recorder: steps begin late by p50 %.3f, p99 %.3f ms; they take p50 %.3f, p99 %.3f ms%n",
          with == 1 ? "with   " : "without",
          percentile(late[with], 0.5),
          percentile(late[with], 0.99),
          percentile(took[with], 0.5),
          percentile(took[with], 0.99));
    }
  }

  private static double percentile(long[] nanos, double share) {
    long[] sorted = nanos.clone();
    Arrays.sort(sorted);
    return sorted[(int) (share * (sorted.length - 1))] / 1e6;
  }

  private static void run(Path folder, boolean recorded, long[] late, long[] took, int from) throws Exception {
    LocalBus bus = new LocalBus("rover");
    Recorder recorder = null;
    if (recorded) {
      recorder =
          new Recorder(
              ServiceContext.of("rover", XmlConfiguration.inMemory("Recorder", Map.of()))
                  .transport(bus)
                  .logDirectory(Files.createTempDirectory(folder, "run"))
                  .build());
      recorder.start();
    }
    Connection control = bus.connect("Control", new Deaf());
    long due = System.nanoTime() + PERIOD_NANOS;
    for (int step = 0; step < STEPS; step++) {
      while (System.nanoTime() < due) {
        java.util.concurrent.locks.LockSupport.parkNanos(due - System.nanoTime());
      }
      long began = System.nanoTime();
      publish(control, Channels.STATE, new StateInformation().x(11.0).y(48.0).psi(step * 0.001), step);
      for (int i = 0; i < COMMANDS; i++) {
        publish(control, Channels.ACTUATION, new PercentageCommand().actuatorName("A" + i).percentage(i), step);
      }
      late[from + step] = began - due;
      took[from + step] = System.nanoTime() - began;
      due += PERIOD_NANOS;
    }
    if (recorder != null) {
      recorder.kill();
      if (recorder.dropped() > 0) {
        System.out.println(recorder.dropped() + " messages dropped");
      }
    }
  }

  private static void publish(Connection control, Channel<?> channel, U2SAData message, long step) {
    message.systemId("rover");
    message.timestamp(step);
    message.freeze();
    control.publish(channel, message);
  }

  /** Subscribes to nothing. */
  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("subscribed to nothing");
    }

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }
}
