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
 * Everything a service gets at construction: its system, configuration, clock and communication.
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
  private final boolean trial;
  private final Execution execution;
  private final DeviceSource devices;
  private final RememberedStates remembered;
  private final Deque<Runnable> closings = new ConcurrentLinkedDeque<>();
  private volatile ServiceInstance predecessor; // null if none, or already released

  private ServiceContext(Builder builder) {
    systemId = Topic.checkSystemId(builder.systemId);
    configuration = builder.configuration;
    execution = builder.execution;
    clock = execution.clock(builder.clock);
    transport = builder.transport;
    logDirectory = builder.logDirectory;
    messageTypes = builder.messageTypes != null ? builder.messageTypes : MessageTypes.discovered();
    seed = builder.seed;
    restart = builder.restart;
    trial = builder.trial;
    predecessor = builder.predecessor;
    devices = builder.devices;
    remembered = builder.remembered;
  }

  /** Builds a context for a service of the given system and configuration. */
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

  /** Clock of the run. */
  public Clock clock() {
    return clock;
  }

  /** Connection to the Communication Manager; if absent, the configured address is used. */
  public Optional<Transport> transport() {
    return Optional.ofNullable(transport);
  }

  /** Directory of the log file. */
  public Path logDirectory() {
    return logDirectory;
  }

  /** Message types that can be decoded. */
  public MessageTypes messageTypes() {
    return messageTypes;
  }

  /** Seed of the run, from which all randomness in a service derives. */
  public long seed() {
    return seed;
  }

  /** Copy for a service whose execution is recorded or replayed. */
  public ServiceContext with(Execution kept) {
    Builder builder =
        of(systemId, configuration)
            .clock(clock)
            .logDirectory(logDirectory)
            .messageTypes(messageTypes)
            .seed(seed)
            .restart(restart)
            .devices(devices)
            .remembered(remembered)
            .trial(trial);
    builder.transport = transport;
    builder.predecessor = predecessor;
    builder.execution = Objects.requireNonNull(kept, "kept");
    return builder.build();
  }

  /** Devices that the host of the run provides, such as those of a simulated vehicle. */
  public DeviceSource devices() {
    return devices;
  }

  /** What the services of this process remembered last. */
  RememberedStates remembered() {
    return remembered;
  }

  /** Hook of a recorder or replay. */
  public Execution execution() {
    return execution;
  }

  /** The service to replace, until the swap is done. */
  Optional<ServiceInstance> predecessor() {
    return Optional.ofNullable(predecessor);
  }

  /** Whether the service replaces a running one ({@link ServiceSwap}). */
  public boolean isSwap() {
    return predecessor != null || execution.inheritance().isPresent();
  }

  /** Releases the predecessor. */
  void forgetPredecessor() {
    predecessor = null;
  }

  /**
   * Whether the service is restarted in this run, in the same process or another, and must resume
   * its saved state.
   */
  public boolean isRestart() {
    return restart;
  }

  /**
   * Called where a constructor is about to open a device or another resource that only one service
   * can hold. Before a running service is restarted, its successor is constructed once as a trial,
   * so that a wrong file leaves the running one alone; the trial ends here.
   *
   * @throws TrialEndedException if this is the trial
   */
  public void beforeDevice() {
    if (trial) {
      throw new TrialEndedException();
    }
  }

  /** Adds how to close a resource that a service's constructor opened, in case it fails later. */
  public void onAbandon(Runnable closing) {
    closings.push(closing);
  }

  /**
   * Closes the log file, the connection and the devices of a service whose constructor failed, so
   * that there is no instance to kill. For code that constructs services. Idempotent.
   */
  public void abandon() {
    for (Runnable closing = closings.poll(); closing != null; closing = closings.poll()) {
      closing.run();
    }
  }

  /** Builder. Defaults: real time, logs in {@code out/logs}, seed 1. */
  public static final class Builder {
    private final String systemId;
    private final XmlConfiguration configuration;
    private Clock clock = new SystemClock();
    private Transport transport;
    private Path logDirectory = Paths.get("out", "logs");
    private MessageTypes messageTypes;
    private long seed = 1;
    private boolean restart;
    private boolean trial;
    private ServiceInstance predecessor;
    private Execution execution = Execution.NONE;
    private DeviceSource devices = DeviceSource.NONE;
    private RememberedStates remembered = new RememberedStates();

    private Builder(String systemId, XmlConfiguration configuration) {
      this.systemId = Objects.requireNonNull(systemId, "systemId");
      this.configuration = Objects.requireNonNull(configuration, "configuration");
    }

    /** Sets the clock of the run, shared by all services of a system. */
    public Builder clock(Clock value) {
      clock = Objects.requireNonNull(value, "clock");
      return this;
    }

    /** Sets the connection to the Communication Manager. */
    public Builder transport(Transport value) {
      transport = Objects.requireNonNull(value, "transport");
      return this;
    }

    /** Sets the directory of the log file. */
    public Builder logDirectory(Path value) {
      logDirectory = Objects.requireNonNull(value, "logDirectory");
      return this;
    }

    /** Sets the message types that can be decoded; default: those on the class path. */
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
     * Makes the service replace a running one by a {@link ServiceSwap}: it gets that service's
     * name, log and connection, and does not connect on its own.
     */
    public Builder inPlaceOf(ServiceInstance running) {
      predecessor = Objects.requireNonNull(running, "running");
      return this;
    }

    /** Sets where devices come from that replace the configured ones. */
    public Builder devices(DeviceSource value) {
      devices = Objects.requireNonNull(value, "devices");
      return this;
    }

    /** Sets where the services of this process keep what they remember, besides their files. */
    public Builder remembered(RememberedStates value) {
      remembered = Objects.requireNonNull(value, "remembered");
      return this;
    }

    /** Sets whether the service is restarted in this run. */
    public Builder restart(boolean value) {
      restart = value;
      return this;
    }

    /** Sets whether the service is only constructed, as a trial that opens no device. */
    public Builder trial(boolean value) {
      trial = value;
      return this;
    }

    /** Builds the context. */
    public ServiceContext build() {
      return new ServiceContext(this);
    }
  }
}
