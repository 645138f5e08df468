package org.u2sa.service;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Deque;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.handover.RememberedStates;

/**
 * Everything a service gets at construction: its system, configuration, clock and communication.
 */
public final class ServiceContext {
  /** Devices that replace the configured ones in a run, such as a simulated vehicle's sensors. */
  public interface DeviceSource {
    /** Provides none: every service opens its configured device. */
    DeviceSource NONE =
        new DeviceSource() {
          @Override
          public <D> Optional<D> device(
              Class<D> port, String service, XmlConfiguration variables, Clock clock) {
            return Optional.empty();
          }
        };

    /**
     * Device of a service; called once, while the service is constructed.
     *
     * @param port kind of device: an interface of {@code org.u2sa.device.port}
     * @param variables variables of the service; those determined by the device may be overridden
     * @return empty: the service opens its configured device
     * @throws org.u2sa.interfaces.BadInputException if it must not do so and no replacement exists
     */
    <D> Optional<D> device(Class<D> port, String service, XmlConfiguration variables, Clock clock);

    /** Copy with a different device of one kind, created with the service's clock. */
    default <P> DeviceSource with(Class<P> kind, Function<Clock, P> device) {
      DeviceSource others = this;
      return new DeviceSource() {
        @Override
        public <D> Optional<D> device(
            Class<D> port, String service, XmlConfiguration variables, Clock clock) {
          return port == kind
              ? Optional.of(port.cast(device.apply(clock)))
              : others.device(port, service, variables, clock);
        }
      };
    }
  }

  /** Records the executions of services created after it, such as a recorder. */
  public interface ExecutionKeeper {
    /** Called before a service of that class is created; empty if it is not recorded. */
    Optional<Execution> keep(String className, ServiceContext context);
  }

  /** Ends a service's trial construction at its device. Not a failure; caught by launchers only. */
  public static final class TrialEnded extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private TrialEnded() {
      super("a trial opens no device");
    }
  }

  private final Builder made; // no longer modified
  private final Clock clock;
  private final Deque<Runnable> closings = new ConcurrentLinkedDeque<>();
  private volatile ServiceInstance predecessor; // null if none, or already released

  private ServiceContext(Builder builder) {
    made = builder;
    Topic.checkSystemId(made.systemId);
    clock = made.execution.clock(made.clock);
    predecessor = made.predecessor;
    made.predecessor = null; // or each service would hold all its predecessors
    if (made.messageTypes == null) {
      made.messageTypes = MessageTypes.discovered();
    }
  }

  /** Builds a context for a service of the given system and configuration. */
  public static Builder of(String systemId, XmlConfiguration configuration) {
    return new Builder(systemId, configuration);
  }

  public String systemId() {
    return made.systemId;
  }

  public XmlConfiguration configuration() {
    return made.configuration;
  }

  public Clock clock() {
    return clock;
  }

  /** Connection to the Communication Manager; if absent, the configured address is used. */
  public Optional<Transport> transport() {
    return Optional.ofNullable(made.transport);
  }

  public Path logDirectory() {
    return made.logDirectory;
  }

  public MessageTypes messageTypes() {
    return made.messageTypes;
  }

  /** Seed of the run, from which all randomness in a service derives. */
  public long seed() {
    return made.seed;
  }

  /** Copy for a service whose execution is recorded or replayed. */
  public ServiceContext with(Execution kept) {
    Builder builder = made.copy();
    builder.clock = clock;
    builder.predecessor = predecessor;
    builder.execution = Objects.requireNonNull(kept, "kept");
    return builder.build();
  }

  /** Devices that the host of the run provides, such as those of a simulated vehicle. */
  public DeviceSource devices() {
    return made.devices;
  }

  RememberedStates remembered() {
    return made.remembered;
  }

  /** Hook of a recorder or replay. */
  public Execution execution() {
    return made.execution;
  }

  /** The service to replace, until the swap is done. */
  Optional<ServiceInstance> predecessor() {
    return Optional.ofNullable(predecessor);
  }

  /** Whether the service replaces a running one ({@link ServiceSwap}). */
  public boolean isSwap() {
    return predecessor != null || made.execution.inheritance().isPresent();
  }

  /** Releases the predecessor. */
  void forgetPredecessor() {
    predecessor = null;
  }

  /** Whether the service is restarted in this run, and must resume its saved state. */
  public boolean isRestart() {
    return made.restart;
  }

  /**
   * Called before a constructor opens a device or another exclusive resource. A restart first
   * constructs the successor as a trial, so that an invalid file does not disturb the running
   * service; the trial ends here.
   *
   * @throws TrialEnded if this is a trial
   */
  public void beforeDevice() {
    if (made.trial) {
      throw new TrialEnded();
    }
  }

  /** Adds an action that closes a resource if the constructor fails later. */
  public void onAbandon(Runnable closing) {
    closings.push(closing);
  }

  /** Closes what a failed constructor opened: log file, connection, devices. Idempotent. */
  public void abandon() {
    for (Runnable closing = closings.poll(); closing != null; closing = closings.poll()) {
      closing.run();
    }
  }

  /** Builder. Defaults: real time, logs in {@code out/logs}, seed 1. */
  public static final class Builder implements Cloneable {
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

    /** Sets the clock shared by all services of a system. */
    public Builder clock(Clock value) {
      clock = Objects.requireNonNull(value, "clock");
      return this;
    }

    /** Sets the connection to the Communication Manager. */
    public Builder transport(Transport value) {
      transport = Objects.requireNonNull(value, "transport");
      return this;
    }

    public Builder logDirectory(Path value) {
      logDirectory = Objects.requireNonNull(value, "logDirectory");
      return this;
    }

    /** Sets the message types that can be decoded; default: those on the class path. */
    public Builder messageTypes(MessageTypes value) {
      messageTypes = Objects.requireNonNull(value, "messageTypes");
      return this;
    }

    public Builder seed(long value) {
      seed = value;
      return this;
    }

    /**
     * Makes the service replace a running one by a {@link ServiceSwap}, so that it does not connect
     * by itself.
     */
    public Builder inPlaceOf(ServiceInstance running) {
      predecessor = Objects.requireNonNull(running, "running");
      return this;
    }

    /** Sets the source of devices that replace the configured ones. */
    public Builder devices(DeviceSource value) {
      devices = Objects.requireNonNull(value, "devices");
      return this;
    }

    /** Sets the directory for the persistent state of this process's services. */
    public Builder remembered(RememberedStates value) {
      remembered = Objects.requireNonNull(value, "remembered");
      return this;
    }

    public Builder restart(boolean value) {
      restart = value;
      return this;
    }

    /** Sets whether the service is only constructed, as a trial that opens no device. */
    public Builder trial(boolean value) {
      trial = value;
      return this;
    }

    public ServiceContext build() {
      return new ServiceContext(copy());
    }

    private Builder copy() {
      try {
        return (Builder) clone();
      } catch (CloneNotSupportedException e) {
        throw new IllegalStateException(e); // it is Cloneable
      }
    }
  }
}
