package org.u2sa.core.communication;

import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.Configurator;
import org.u2sa.interfaces.Range;
import org.u2sa.interfaces.Variable;

/**
 * What one client, and all together, may ask of the broker.
 *
 * @param clients connections at once
 * @param messagesPerS packets a second from one client; beyond it, it is read more slowly
 * @param bytesPerS bytes of payload a second from one client, likewise
 * @param patienceMicros how long a client may take nothing, or acknowledge nothing, while something
 *     waits for it [µs]
 */
record BrokerLimits(int clients, int messagesPerS, int bytesPerS, long patienceMicros) {
  static final Variable<Integer> CLIENTS =
      Variable.integer("CLIENTS AT MOST")
          .range(Range.of(4, 100_000))
          .ifAbsent(512)
          .describedAs("Connections that the embedded broker takes at once.");

  static final Variable<Integer> MESSAGES_PER_S =
      Variable.integer("CLIENT MESSAGES PER SECOND")
          .range(Range.of(10, 10_000_000))
          .ifAbsent(10_000)
          .describedAs(
              "Packets a second that the embedded broker reads from one client; more wait at the client.");

  static final Variable<Integer> BYTES_PER_S =
      Variable.integer("CLIENT BYTES PER SECOND")
          .range(Range.of(10_000, 2_000_000_000))
          .ifAbsent(20_000_000)
          .describedAs(
              "Bytes of payload a second that the embedded broker reads from one client; more wait at the client.");

  static final Variable<Double> PATIENCE =
      Variable.number("CLIENT PATIENCE", "s")
          .range(Range.of(0.5, 3_600.0))
          .ifAbsent(15.0)
          .describedAs(
              "Time after which the embedded broker puts a client out that reads or acknowledges nothing.");

  /** Connections that have not said who they are, from one address. */
  static final int STRANGERS_PER_ADDRESS = 32;

  /** Connections that have not said who they are, from everywhere. */
  static final int STRANGERS = 256;

  /** Time for encryption and the first packet [ms]. */
  static final long INTRODUCTION_WITHIN_MS = 10_000;

  static final int FILTERS_PER_CLIENT = 256;
  static final int LONGEST_TOPIC = 1_024;
  static final int DEEPEST_TOPIC = 32;
  static final int LONGEST_CLIENT_ID = 512;
  static final int RETAINED_TOPICS = 4_096;

  /** Messages on their way through the broker: half of what its queues hold. */
  static final int ON_THE_WAY = 400;

  /** Bytes that may come before the first packet is whole, encryption's included. */
  static final int STRANGERS_BYTES = 64 * 1_024;

  /** As the codec's limit: nobody could read more. */
  static final int LONGEST_PAYLOAD = 1 << 20;

  /** A payload with its topic. */
  static final int LONGEST_PACKET = LONGEST_PAYLOAD + 16 * 1_024;

  /**
   * Bytes that were published for acknowledgement, by all, since the oldest message that a client
   * has not acknowledged: Moquette's queue for it knows no bound.
   */
  static final long UNACKNOWLEDGED_BYTES = 32 << 20;

  /** Bytes that wait for one client before messages of QoS 0 to it are dropped. */
  static final long UNREAD_BYTES = 256 * 1_024;

  static BrokerLimits of(Configurator configuration) {
    return new BrokerLimits(
        configuration.getVariable(CLIENTS),
        configuration.getVariable(MESSAGES_PER_S),
        configuration.getVariable(BYTES_PER_S),
        Clock.micros(configuration.getVariable(PATIENCE)));
  }

  /** Connections of one user: no one can take all. */
  int clientsPerUser() {
    return Math.max(1, clients / 2);
  }
}
