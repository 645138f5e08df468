import java.nio.file.Path;
import java.util.Map;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.Recorder;
import org.u2sa.service.ServiceContext;

/**
 * Publishes numbered messages, 500 a second, on a bus that is recorded, until it is killed ({@code kill.py}). Says the number and the time
 * [µs] of each once it is published. Argument: the recording's folder.
 */
public final class KilledWriter {
  private static final long PERIOD_MICROS = 2_000;

  private KilledWriter() {}

  public static void main(String[] args) throws InterruptedException {
    LocalBus bus = new LocalBus("rover");
    new Recorder(
            ServiceContext.of("rover", XmlConfiguration.inMemory("Recorder", Map.of()))
                .transport(bus)
                .logDirectory(Path.of(args[0]))
                .build())
        .start();
    Connection publisher = bus.connect("Publisher", new Deaf());
    Clock clock = new SystemClock();
    Clock.Waiter waiter = clock.newWaiter("publisher");
    System.out.println("begun");
    long due = clock.micros();
    for (long number = 0; ; number++) {
      StateInformation message = new StateInformation().sensorName("gps").x(11.0).y(48.0).z(number);
      message.systemId("rover");
      message.timestamp(clock.micros());
      message.freeze();
      publisher.publish(Channels.STATE, message);
      System.out.println(number + " " + message.timestamp().getAsLong());
      due += PERIOD_MICROS;
      while (clock.micros() < due) {
        waiter.await(due);
      }
    }
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
