package org.u2sa.benchmarks.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** Simulated vehicles, each with a connection and a system ID of its own, as light as can be. */
final class Vehicles implements AutoCloseable {
  private final List<Connection> connections = new ArrayList<>();

  /** Connects them one after the other. */
  Vehicles(int count, int port, MessageCodec codec) {
    try {
      for (int i = 0; i < count; i++) {
        connections.add(
            new MqttTransport("127.0.0.1", port, id(i), codec)
                .waiting(30.0)
                .connect("StateEstimator", new Deaf()));
      }
    } catch (CommunicationException e) {
      close();
      throw e;
    }
  }

  private static String id(int number) {
    return "v" + number;
  }

  /**
   * Each vehicle publishes its state at a rate, all evenly spread over the period.
   *
   * @param perS states a second of each vehicle
   * @param seconds how long
   * @return how many were to be published; those that a connection refused are among them
   */
  long publish(double perS, double seconds) {
    double gapNanos = 1e9 / (perS * connections.size());
    long count = Math.round(seconds * perS * connections.size());
    long begun = System.nanoTime();
    for (long n = 0; n < count; n++) {
      long due = begun + Math.round(n * gapNanos);
      for (long wait = due - System.nanoTime(); wait > 0; wait = due - System.nanoTime()) {
        LockSupport.parkNanos(wait);
      }
      int vehicle = (int) (n % connections.size());
      // when it was due: a sender that is late shows as latency, and not as a lower rate
      connections.get(vehicle).publish(Channels.STATE, state(id(vehicle), due));
    }
    return count;
  }

  private static StateInformation state(String system, long dueNanos) {
    StateInformation state = new StateInformation();
    state.systemId(system);
    state.timestamp(dueNanos / 1_000);
    state.sensorName("StateEstimator").referenceFrame(ReferenceFrame.GLOBAL);
    state.x(-157.9).y(21.3).z(12.5).psi(1.57).xDot(1.0).yDot(0.1).psiDot(0.01);
    state.freeze();
    return state;
  }

  /** Messages that connections did not take. */
  long refused() {
    return connections.stream().mapToLong(Connection::refused).sum();
  }

  @Override
  public void close() {
    connections.forEach(Connection::close);
  }

  private record Deaf() implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("not subscribed to " + channel);
    }

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }
}
