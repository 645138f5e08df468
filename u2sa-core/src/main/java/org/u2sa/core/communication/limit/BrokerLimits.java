package org.u2sa.core.communication.limit;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/** Limits of the embedded broker, per client and in total. */
public record BrokerLimits(
    @Variable(min = 4, max = 100_000, ifAbsent = 512)
        @Description(
            "Maximum connections to the broker; fewer if the process may open less than 1,152 files.")
        int maxClients,
    @Variable(min = 10, max = 10_000_000, ifAbsent = 100_000)
        @Description(
            "Packets per second that the embedded broker reads from one client; more must wait. A tenth of that while a subscriber to its messages lags.")
        int clientMessagesPerSecond,
    @Variable(min = 10_000, max = 2_000_000_000, ifAbsent = 200_000_000)
        @Description(
            "Bytes per second that the embedded broker reads from one client; more must wait. A tenth of that while a subscriber to its messages lags.")
        int clientBytesPerSecond,
    @Variable(min = 100, max = 100_000_000, ifAbsent = 250_000)
        @Description(
            "Packets per second that the embedded broker reads from all clients together. Each client's first 1 % of CLIENT MESSAGES PER SECOND is not counted and never waits for other clients.")
        int totalMessagesPerSecond,
    @Variable(min = 1, max = 1_000_000, ifAbsent = 200)
        @Description(
            "Subscriptions and queries to all services per second that the embedded broker reads from one user; more must wait.")
        int clientQuestionsPerSecond,
    @Variable(min = 1, max = 1_000_000, ifAbsent = 50)
        @Description(
            "Changes of configuration, services and goals per second that the embedded broker accepts from one client; more are refused. One larger than 4 KiB counts as several.")
        int clientOrdersPerSecond,
    @Variable(min = 16, max = 1_000_000, ifAbsent = 4_096)
        @Description(
            "Topics for which the embedded broker retains a client's message; one user may take half. Emergency stop, failsafe and arming state have separate space.")
        int maxRetainedTopics,
    @Variable(min = 65_536, max = 2_000_000_000, ifAbsent = 32 << 20)
        @Description("Total bytes of retained messages; at most a quarter of the heap.")
        int maxRetainedBytes,
    @Variable(min = 16_384, max = 2_000_000_000, ifAbsent = 8 << 20)
        @Description(
            "Bytes of retained messages of one user, or of one client where there are no users.")
        int maxClientRetainedBytes,
    @Variable(min = 1 << 20, max = 2_000_000_000, ifAbsent = 32 << 20)
        @Description(
            "Bytes published after a message that a client has not acknowledged, before the embedded broker disconnects the client.")
        int maxUnacknowledgedBytes,
    @Variable(unit = "s", min = 0.5, max = 3_600, ifAbsent = 15)
        @Description(
            "Time after which the embedded broker disconnects a client that neither reads nor acknowledges its pending messages.")
        double clientPatience) {
  /** Unidentified connections from one address. */
  public static final int PENDING_PER_ADDRESS = 32;

  /** Unidentified connections in total. */
  public static final int PENDING = 256;

  /** Time for encryption and the first packet [ms]. */
  public static final long CONNECT_WITHIN_MS = 10_000;

  /** Topic filters of one client. */
  public static final int FILTERS_PER_CLIENT = 256;

  /** Filters of all connections of one user: each is matched against each new topic. */
  public static final int FILTERS_PER_USER = 2_048;

  static final int LONGEST_TOPIC = 1_024;
  static final int DEEPEST_TOPIC = 32;

  /** Bytes of a client identifier. */
  public static final int LONGEST_CLIENT_ID = 512;

  /** Size of a will, which the broker keeps while the client is connected. */
  public static final int LONGEST_WILL = 16 * 1_024;

  /** One in this many connections is reserved for operators. */
  private static final int OPERATORS_PART = 16;

  /** Files, devices and sockets of the process's services. */
  static final int OWN_FILES = 128;

  static final int MIN_CLIENTS = 16;

  /** Bytes allowed before the first packet is complete, encryption included. */
  public static final int FIRST_PACKET_BYTES = 64 * 1_024;

  /** The codec's limit. */
  public static final int LONGEST_PAYLOAD = 1 << 20;

  /** A payload with its topic. */
  public static final int LONGEST_PACKET = LONGEST_PAYLOAD + 16 * 1_024;

  /** Longest packet other than PUBLISH and CONNECT, such as SUBSCRIBE. */
  public static final int LONGEST_CONTROL_PACKET = 8 * 1_024;

  /** A will with topic, names and password. */
  public static final int LONGEST_CONNECT = LONGEST_WILL + LONGEST_CONTROL_PACKET;

  /** Backlog of one client beyond which QoS 0 messages to it are dropped [bytes]. */
  public static final long UNREAD_BYTES = 256 * 1_024;

  /** Backlog of one client beyond which its publishers are read more slowly [bytes]. */
  public static final long BEHIND_BYTES = UNREAD_BYTES / 4;

  /**
   * PINGREQs read from one client per second; more must wait. Each has 2 bytes and demands an
   * answer; the shortest keep-alive takes one per second (MQTT 3.1.1, section 3.1.2.10).
   */
  public static final double PINGS_PER_SECOND = 10.0;

  /** Bytes read from one client per turn. */
  public static final int READ_AT_ONCE = 16 * 1_024;

  /**
   * These limits with fewer clients if necessary, so that half of the open files not needed by
   * services remain for connections that have not logged in: otherwise clients of any role could
   * lock operators out.
   */
  BrokerLimits within(int openFiles) {
    int clients = Math.max(MIN_CLIENTS, (openFiles - OWN_FILES) / 2);
    return clients >= maxClients
        ? this
        : new BrokerLimits(
            clients,
            clientMessagesPerSecond,
            clientBytesPerSecond,
            totalMessagesPerSecond,
            clientQuestionsPerSecond,
            clientOrdersPerSecond,
            maxRetainedTopics,
            maxRetainedBytes,
            maxClientRetainedBytes,
            maxUnacknowledgedBytes,
            clientPatience);
  }

  /** {@link #clientPatience} [µs]. */
  public long patienceMicros() {
    return Clock.micros(clientPatience);
  }

  /** Maximum connections per user. */
  public int clientsPerUser() {
    return Math.max(1, maxClients / 2);
  }

  /** Maximum connections of non-operators; the rest are reserved for operators. */
  public int clientsBesidesOperators() {
    return maxClients - Math.max(1, maxClients / OPERATORS_PART);
  }

  /** Whether a topic or filter exceeds the length or depth limit. */
  public static boolean isTooLong(String topic) {
    return topic.length() > LONGEST_TOPIC
        || topic.chars().filter(letter -> letter == '/').count() >= DEEPEST_TOPIC;
  }
}
