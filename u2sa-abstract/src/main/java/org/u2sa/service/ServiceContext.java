package org.u2sa.service;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Deque;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageTypes;

/**
 * All that a service is given at its construction: whose it is, its configuration, its clock and
 * its way to talk.
 */
public final class ServiceContext {
  private final String systemId;
  private final XmlConfiguration configuration;
  private final Clock clock;
  private final Transport transport;
  private final Path logDirectory;
  private final MessageTypes messageTypes;
  private final long seed;
  private final boolean restart;
  private final Execution execution; // null if nobody keeps it
  private final Deque<Runnable> closings = new ConcurrentLinkedDeque<>();
  private volatile U2SAService predecessor; // null if there is none, or none any more

  private ServiceContext(Builder builder) {
    systemId = Topic.checkSystemId(builder.systemId);
    configuration = builder.configuration;
    execution = builder.execution;
    clock = execution == null ? builder.clock : execution.clock();
    transport = builder.transport;
    logDirectory = builder.logDirectory;
    messageTypes = builder.messageTypes != null ? builder.messageTypes : MessageTypes.discovered();
    seed = builder.seed;
    restart = builder.restart;
    predecessor = builder.predecessor;
  }

  /** Begins a context for a service of the given system with the given configuration. */
  public static Builder of(String systemId, XmlConfiguration configuration) {
    return new Builder(systemId, configuration);
  }

  /** The vehicle that the service is part of. */
  public String systemId() {
    return systemId;
  }

  /** The service's own variables. */
  public XmlConfiguration configuration() {
    return configuration;
  }

  /** The time of the run. */
  public Clock clock() {
    return clock;
  }

  /** The way to the Communication Manager; if absent, the configuration's address is used. */
  public Optional<Transport> transport() {
    return Optional.ofNullable(transport);
  }

  /** Where the log file is written. */
  public Path logDirectory() {
    return logDirectory;
  }

  /** The message types that can be read. */
  public MessageTypes messageTypes() {
    return messageTypes;
  }

  /** The run's seed: whatever is random in a service derives from it. */
  public long seed() {
    return seed;
  }

  /** This context for a service whose execution is kept, or repeated. */
  public ServiceContext with(Execution kept) {
    Builder builder =
        of(systemId, configuration)
            .clock(clock)
            .logDirectory(logDirectory)
            .messageTypes(messageTypes)
            .seed(seed)
            .restart(restart);
    builder.transport = transport;
    builder.predecessor = predecessor;
    builder.execution = Objects.requireNonNull(kept, "kept");
    return builder.build();
  }

  /** What passes between the service and the world, if that is kept or repeated. */
  public Optional<Execution> execution() {
    return Optional.ofNullable(execution);
  }

  /** Whose place the service is to take, until it has. */
  Optional<U2SAService> predecessor() {
    return Optional.ofNullable(predecessor);
  }

  /** Whether the service is made to take the place of one that runs ({@link ServiceSwap}). */
  public boolean isSwap() {
    return predecessor != null || inheritance().isPresent();
  }

  /** The place that the service is to take in a repeated execution. */
  Optional<Execution.Inheritance> inheritance() {
    return execution().flatMap(Execution::inheritance);
  }

  /** Lets go of the predecessor. */
  void forgetPredecessor() {
    predecessor = null;
  }

  /**
   * Whether the service ran before in this run and is started anew, in the same process or another:
   * then it takes its work up where it was left.
   */
  public boolean isRestart() {
    return restart;
  }

  /** Takes note of how to close what the service opened while it was being constructed. */
  void onAbandon(Runnable closing) {
    closings.push(closing);
  }

  /**
   * Closes the log file and the connection of a service whose constructor failed, so that nobody
   * has the service to {@link U2SAService#kill}. For those who construct services. Safe to call
   * twice.
   */
  public void abandon() {
    for (Runnable closing = closings.poll(); closing != null; closing = closings.poll()) {
      closing.run();
    }
  }

  /**
   * Collects what a context holds. Without further calls: real time, logs in {@code out/logs}, seed
   * 1.
   */
  public static final class Builder {
    private final String systemId;
    private final XmlConfiguration configuration;
    private Clock clock = new SystemClock();
    private Transport transport;
    private Path logDirectory = Paths.get("out", "logs");
    private MessageTypes messageTypes;
    private long seed = 1;
    private boolean restart;
    private U2SAService predecessor;
    private Execution execution;

    private Builder(String systemId, XmlConfiguration configuration) {
      this.systemId = Objects.requireNonNull(systemId, "systemId");
      this.configuration = Objects.requireNonNull(configuration, "configuration");
    }

    /** Sets the time of the run, which all services of a system share. */
    public Builder clock(Clock value) {
      clock = Objects.requireNonNull(value, "clock");
      return this;
    }

    /** Sets the way to the Communication Manager. */
    public Builder transport(Transport value) {
      transport = Objects.requireNonNull(value, "transport");
      return this;
    }

    /** Sets where the log file is written. */
    public Builder logDirectory(Path value) {
      logDirectory = Objects.requireNonNull(value, "logDirectory");
      return this;
    }

    /** Sets the message types that can be read; without it, those found on the class path. */
    public Builder messageTypes(MessageTypes value) {
      messageTypes = Objects.requireNonNull(value, "messageTypes");
      return this;
    }

    /** Sets the run's seed. */
    public Builder seed(long value) {
      seed = value;
      return this;
    }

    /**
     * Says that the service is to take the place of one that runs, by a {@link ServiceSwap}: it
     * gets that one's name, log and connection, and does not connect before.
     */
    public Builder inPlaceOf(U2SAService running) {
      predecessor = Objects.requireNonNull(running, "running");
      return this;
    }

    /** Says whether the service ran before in this run. */
    public Builder restart(boolean value) {
      restart = value;
      return this;
    }

    /** The finished context. */
    public ServiceContext build() {
      return new ServiceContext(this);
    }
  }
}
