package org.u2sa.testkit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceSwap;
import org.u2sa.service.U2SAService;

/**
 * Runs services under test as they run on a vehicle, on threads of their own, but in simulated time
 * that the test moves, and records what they publish.
 *
 * <pre>{@code
 * try (ServiceKit kit = new ServiceKit().with("HEADING GAIN", 100.0)) {
 *   kit.start(DifferentialDriveControl::new);
 *   kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(1.0, 0.5, 0.0)));
 *   kit.advance(0.1);
 *   assertThat(kit.percent("RIGHT WHEEL")).isGreaterThan(kit.percent("LEFT WHEEL"));
 * }
 * }</pre>
 *
 * <p>Each call returns when all services have answered, so no test waits or guesses.
 */
public final class ServiceKit implements AutoCloseable {
  /** The system's ID in the kit's messages. */
  public static final String SYSTEM_ID = "kit";

  private final LockstepClock clock = new LockstepClock();
  private final LocalBus bus = new LocalBus(SYSTEM_ID);
  private final Map<String, Object> variables = new LinkedHashMap<>();
  private final Map<String, List<U2SAData>> published =
      new LinkedHashMap<>(); // by channel; guarded by itself
  private final Deque<U2SAService> services = new ArrayDeque<>();
  private final Path directory;
  private long seed = 1;

  /** A kit whose time is 0 and in which nothing runs. */
  public ServiceKit() {
    try {
      directory = Files.createTempDirectory("u2sa-kit");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    bus.attach(this::record);
  }

  private void record(Channel<?> channel, U2SAData message) {
    synchronized (published) {
      published.computeIfAbsent(channel.name(), name -> new ArrayList<>()).add(message);
    }
  }

  /** Sets a configuration variable of the services started from now on. */
  public ServiceKit with(String variableName, Object value) {
    variables.put(variableName, value);
    return this;
  }

  /** Forgets the variables set so far, for a service that has others. */
  public ServiceKit withoutVariables() {
    variables.clear();
    return this;
  }

  /** Sets the seed of the services started from now on. */
  public ServiceKit seed(long newSeed) {
    seed = newSeed;
    return this;
  }

  /** The context that a service started now would get. */
  public ServiceContext context() {
    return contextBuilder().build();
  }

  private ServiceContext.Builder contextBuilder() {
    return ServiceContext.of(SYSTEM_ID, XmlConfiguration.inMemory("the test", variables))
        .clock(clock)
        .transport(bus)
        .logDirectory(directory)
        .seed(seed);
  }

  /**
   * Puts a new service in the place of one that runs, as a launcher does on order, and returns when
   * it waits for its first message or step.
   *
   * @throws IllegalStateException with the reason if the swap was refused; the old one goes on
   */
  public <S extends U2SAService> S swap(
      U2SAService running, Function<ServiceContext, S> constructor) {
    S successor = constructor.apply(contextBuilder().inPlaceOf(running).build());
    ServiceSwap swap = new ServiceSwap(running, successor, () -> true).order();
    settle();
    if (!swap.isDecided() || swap.outcome().isPresent()) {
      throw new IllegalStateException("not swapped: " + swap.outcome().orElse("not yet decided"));
    }
    services.push(successor);
    return successor;
  }

  /**
   * Makes a service, starts its thread, and returns when the thread waits for its first message or
   * step.
   */
  public <S extends U2SAService> S start(Function<ServiceContext, S> constructor) {
    return start(constructor.apply(context()));
  }

  /**
   * Ends a service and starts another one in its place as a launcher does on order: what the first
   * one {@code remember}ed, the other one takes over.
   */
  public <S extends U2SAService> S restart(
      U2SAService running, Function<ServiceContext, S> constructor) {
    running.shutDown();
    return start(constructor.apply(contextBuilder().restart(true).build()));
  }

  private <S extends U2SAService> S start(S service) {
    services.push(service);
    service.start();
    settle();
    return service;
  }

  /** Publishes a message as another service would, and returns when all services have answered. */
  public <T extends U2SAData> void publish(Channel<T> channel, T message) {
    send(channel, message);
    settle();
  }

  /**
   * Publishes a message as another service would, before the services get their turn. A frozen one
   * is delivered as it is, for example without a timestamp.
   */
  public <T extends U2SAData> void send(Channel<T> channel, T message) {
    if (!message.isFrozen()) {
      if (message.systemId().isEmpty()) {
        message.systemId(SYSTEM_ID);
      }
      if (message.timestamp().isEmpty()) {
        message.timestamp(clock.micros());
      }
      message.freeze();
    }
    bus.deliver(channel, message);
  }

  /** Lets the services do what is due now, without moving time. */
  public void settle() {
    advance(0.0);
  }

  /** Moves time on by a span [s], and returns when all services have done what was due. */
  public void advance(double seconds) {
    try {
      clock.advance(Clock.micros(seconds));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("the test was interrupted", e);
    }
  }

  /** Time since the kit was made [s]. */
  public double nowS() {
    return Clock.seconds(clock.micros());
  }

  /** The clock of the run. */
  public LockstepClock clock() {
    return clock;
  }

  /** The bus that the services talk through. */
  public LocalBus bus() {
    return bus;
  }

  /** Everything that services published on the channel, oldest first. */
  public <T extends U2SAData> List<T> published(Channel<T> channel) {
    synchronized (published) {
      Class<T> type = channel.type().messageClass();
      return published.getOrDefault(channel.name(), List.of()).stream().map(type::cast).toList();
    }
  }

  /** The last message that a service published on the channel. */
  public <T extends U2SAData> Optional<T> latest(Channel<T> channel) {
    List<T> all = published(channel);
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(all.size() - 1));
  }

  /** Forgets what was published so far. */
  public void forget() {
    synchronized (published) {
      published.clear();
    }
  }

  /**
   * The percentage last commanded to an actuator.
   *
   * @throws NoSuchElementException if it was never commanded
   */
  public double percent(String actuatorName) {
    return published(Channels.ACTUATION).stream()
        .filter(command -> command.actuatorName().equals(actuatorName))
        .filter(PercentageCommand.class::isInstance)
        .mapToDouble(command -> ((PercentageCommand) command).percentage())
        .reduce((first, second) -> second)
        .orElseThrow(
            () -> new NoSuchElementException("no command for actuator \"" + actuatorName + "\""));
  }

  /** The lines of a service's log file so far. */
  public List<String> log(String serviceName) {
    try {
      return Files.readAllLines(directory.resolve(serviceName + ".log"), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Deletes what a service has saved for its restart, as if the disk had been full. */
  public void loseState(String serviceName) {
    try {
      Files.delete(directory.resolve(serviceName + ".progress"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Ends all services, last started first, and removes the log files. */
  @Override
  public void close() {
    services.forEach(U2SAService::shutDown);
    try (Stream<Path> files = Files.walk(directory)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
