package org.u2sa.core.communication;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.time.Clock;

/**
 * What one client, and all together, may ask of the broker.
 *
 * @param clients connections at once
 * @param messagesPerS packets a second from one client; beyond it, it is read more slowly
 * @param bytesPerS bytes of payload a second from one client, likewise
 * @param questionsPerS questions and subscriptions a second from one user, likewise
 * @param ordersPerS orders a second from one client; those beyond it are refused
 * @param retained what may be retained
 * @param unacknowledgedBytes that were published for acknowledgement, by all, since the oldest
 *     message that a client has not acknowledged: Moquette's queue for it knows no bound
 * @param patienceMicros how long a client may take nothing, or acknowledge nothing, while something
 *     waits for it [µs]
 */
record BrokerLimits(
    int clients,
    int messagesPerS,
    int bytesPerS,
    int questionsPerS,
    int ordersPerS,
    Retained retained,
    long unacknowledgedBytes,
    long patienceMicros) {
  /** How many topics clients may retain, how many bytes, and how many bytes one user may. */
  record Retained(int topics, long bytes, long bytesOfOne) {}

  static final VariableDeclaration<Integer> CLIENTS =
      VariableDeclaration.integer("CLIENTS AT MOST")
          .range(Range.of(4, 100_000))
          .ifAbsent(512)
          .describedAs("Connections that the embedded broker takes at once.");

  static final VariableDeclaration<Integer> MESSAGES_PER_S =
      VariableDeclaration.integer("CLIENT MESSAGES PER SECOND")
          .range(Range.of(10, 10_000_000))
          .ifAbsent(10_000)
          .describedAs(
              "Packets a second that the embedded broker reads from one client; more wait at the client.");

  static final VariableDeclaration<Integer> BYTES_PER_S =
      VariableDeclaration.integer("CLIENT BYTES PER SECOND")
          .range(Range.of(10_000, 2_000_000_000))
          .ifAbsent(20_000_000)
          .describedAs(
              "Bytes of payload a second that the embedded broker reads from one client; more wait at the client.");

  static final VariableDeclaration<Integer> QUESTIONS_PER_S =
      VariableDeclaration.integer("CLIENT QUESTIONS PER SECOND")
          .range(Range.of(1, 1_000_000))
          .ifAbsent(200)
          .describedAs(
              "Questions to every service and subscriptions a second that the embedded broker reads from one user; more wait at the client.");

  static final VariableDeclaration<Integer> ORDERS_PER_S =
      VariableDeclaration.integer("CLIENT ORDERS PER SECOND")
          .range(Range.of(1, 1_000_000))
          .ifAbsent(50)
          .describedAs(
              "Changes of configuration, services and goals a second that the embedded broker takes from one client; more are refused. One of more than 4 KiB counts as several.");

  static final VariableDeclaration<Integer> RETAINED_TOPICS =
      VariableDeclaration.integer("RETAINED TOPICS AT MOST")
          .range(Range.of(16, 1_000_000))
          .ifAbsent(4_096)
          .describedAs(
              "Topics of which the embedded broker keeps a message of its clients; one user may take half. Emergency stop, failsafe and arming state have room of their own.");

  static final VariableDeclaration<Integer> RETAINED_BYTES =
      VariableDeclaration.integer("RETAINED BYTES AT MOST")
          .range(Range.of(65_536, 2_000_000_000))
          .ifAbsent(32 << 20)
          .describedAs("Bytes of those messages in all.");

  static final VariableDeclaration<Integer> CLIENT_RETAINED_BYTES =
      VariableDeclaration.integer("CLIENT RETAINED BYTES AT MOST")
          .range(Range.of(16_384, 2_000_000_000))
          .ifAbsent(8 << 20)
          .describedAs(
              "Bytes of those messages of one user, or of one client where there are no users.");

  static final VariableDeclaration<Integer> UNACKNOWLEDGED_BYTES =
      VariableDeclaration.integer("UNACKNOWLEDGED BYTES AT MOST")
          .range(Range.of(1 << 20, 2_000_000_000))
          .ifAbsent(32 << 20)
          .describedAs(
              "Bytes published behind a message after which the embedded broker puts a client out that has not acknowledged it.");

  static final VariableDeclaration<Double> PATIENCE =
      VariableDeclaration.number("CLIENT PATIENCE", "s")
          .range(Range.of(0.5, 3_600.0))
          .ifAbsent(15.0)
          .describedAs(
              "Time after which the embedded broker puts a client out that reads or acknowledges nothing.");

  /** Connections that have not said who they are, from one address. */
  static final int PENDING_PER_ADDRESS = 32;

  /** Connections that have not said who they are, from everywhere. */
  static final int PENDING = 256;

  /** Time for encryption and the first packet [ms]. */
  static final long CONNECT_WITHIN_MS = 10_000;

  static final int FILTERS_PER_CLIENT = 256;

  /** Of all connections of one user: each is compared with each new topic. */
  static final int FILTERS_PER_USER = 2_048;

  static final int LONGEST_TOPIC = 1_024;
  static final int DEEPEST_TOPIC = 32;
  static final int LONGEST_CLIENT_ID = 512;

  /** Messages on their way through the broker: half of what its queues hold. */
  static final int ON_THE_WAY = 400;

  /** Bytes of those messages. */
  static final long BYTES_ON_THE_WAY = 16 << 20;

  /** A client's will, which the broker keeps for as long as the client is there. */
  static final int LONGEST_WILL = 16 * 1_024;

  /** Of so many connections one is kept free for operators. */
  private static final int OPERATORS_PART = 16;

  /** Bytes that may come before the first packet is whole, encryption's included. */
  static final int FIRST_PACKET_BYTES = 64 * 1_024;

  /** As the codec's limit: nobody could read more. */
  static final int LONGEST_PAYLOAD = 1 << 20;

  /** A payload with its topic. */
  static final int LONGEST_PACKET = LONGEST_PAYLOAD + 16 * 1_024;

  /** Bytes that wait for one client before messages of QoS 0 to it are dropped. */
  static final long UNREAD_BYTES = 256 * 1_024;

  static BrokerLimits of(Configurator configuration) {
    return new BrokerLimits(
        configuration.getVariable(CLIENTS),
        configuration.getVariable(MESSAGES_PER_S),
        configuration.getVariable(BYTES_PER_S),
        configuration.getVariable(QUESTIONS_PER_S),
        configuration.getVariable(ORDERS_PER_S),
        new Retained(
            configuration.getVariable(RETAINED_TOPICS),
            configuration.getVariable(RETAINED_BYTES),
            configuration.getVariable(CLIENT_RETAINED_BYTES)),
        configuration.getVariable(UNACKNOWLEDGED_BYTES),
        Clock.micros(configuration.getVariable(PATIENCE)));
  }

  /** Connections of one user: no one can take all. */
  int clientsPerUser() {
    return Math.max(1, clients / 2);
  }

  /** Connections of those who are no operators, so that an operator always finds one free. */
  int clientsBesidesOperators() {
    return clients - Math.max(1, clients / OPERATORS_PART);
  }

  /** Whether a topic or filter is longer or deeper than any may be. */
  static boolean isTooLong(String topic) {
    return topic.length() > LONGEST_TOPIC
        || topic.chars().filter(letter -> letter == '/').count() >= DEEPEST_TOPIC;
  }
}
