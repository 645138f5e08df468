package org.u2sa.core.communication;

import org.u2sa.interfaces.Configurator;
import org.u2sa.interfaces.Range;
import org.u2sa.interfaces.Variable;

/**
 * What one client, and all together, may ask of the broker.
 *
 * @param clients connections at once
 * @param messagesPerS packets a second from one client; beyond it, it is read more slowly
 * @param bytesPerS bytes of payload a second from one client, likewise
 */
record BrokerLimits(int clients, int messagesPerS, int bytesPerS) {
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

  /** Bytes that wait for one client before messages of QoS 0 to it are dropped. */
  static final long UNREAD_BYTES = 256 * 1_024;

  /** How long a client may take nothing, or acknowledge nothing, while something waits for it. */
  static final long PATIENCE_MICROS = 15_000_000;

  static BrokerLimits of(Configurator configuration) {
    return new BrokerLimits(
        configuration.getVariable(CLIENTS),
        configuration.getVariable(MESSAGES_PER_S),
        configuration.getVariable(BYTES_PER_S));
  }

  /** Connections of one user: no one can take all. */
  int clientsPerUser() {
    return Math.max(1, clients / 2);
  }
}
