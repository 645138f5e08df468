package org.u2sa.core.launch;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Run options of a system beyond its files. */
public final class LaunchOptions {
  Clock clock = new SystemClock();
  Path logDirectory = Paths.get("out", "logs");
  long seed = 1;
  Consumer<String> console = line -> {};
  private Optional<Path> changes = Optional.empty();
  boolean oneOfSeveral;
  boolean supervised;
  boolean restart;
  boolean besideManager;
  boolean throughBroker;
  Optional<IntConsumer> otherPort = Optional.empty();
  ServiceContext.DeviceSource devices = ServiceContext.DeviceSource.NONE;
  private final Map<String, Map<String, Object>> overrides = new LinkedHashMap<>();
  private final Map<String, Function<ServiceContext, ? extends U2SAService>> makers =
      new HashMap<>();
  final List<Companion> companions = new ArrayList<>();

  /** Sets the time of the run; without it, real time. */
  public LaunchOptions clock(Clock value) {
    clock = Objects.requireNonNull(value, "clock");
    return this;
  }

  /** Sets where each service's log file is written; without it, {@code out/logs}. */
  public LaunchOptions logDirectory(Path value) {
    logDirectory = Objects.requireNonNull(value, "logDirectory");
    return this;
  }

  /** Sets the seed of all random numbers; 1 by default. */
  public LaunchOptions seed(long value) {
    seed = value;
    return this;
  }

  /**
   * Leaves configuration files untouched: run-time changes go to copies in this folder, which is
   * created at the first change.
   */
  public LaunchOptions changesTo(Path folder) {
    changes = Optional.of(folder);
    return this;
  }

  /** Sets the log of the launcher and the Communication Manager, called once per line. */
  public LaunchOptions console(Consumer<String> value) {
    console = Objects.requireNonNull(value, "console");
    return this;
  }

  /** Reads a configuration file; its changes are saved according to these options. */
  private XmlConfiguration load(Path file) {
    return changes
        .map(folder -> XmlConfiguration.load(file, copyOf(file.toAbsolutePath(), folder)))
        .orElseGet(() -> XmlConfiguration.load(file));
  }

  /** Copies need unique names: files of the same name may come from several folders. */
  private static Path copyOf(Path file, Path folder) {
    Path parent = file.getParent().getFileName();
    return folder.resolve(parent == null ? "root" : parent.toString()).resolve(file.getFileName());
  }

  /**
   * Declares that this process runs one service of a system whose others run elsewhere.
   *
   * @param bySupervisor whether a supervising process restarts this one if necessary, and therefore
   *     handles orders to start and restart
   */
  public LaunchOptions oneOfSeveral(boolean bySupervisor) {
    oneOfSeveral = true;
    supervised = bySupervisor;
    return this;
  }

  /**
   * Overrides a variable for this run, without writing it to the file.
   *
   * @param service the simple name of the service's class, or {@code CommunicationManager}
   */
  public LaunchOptions override(String service, String variable, Object value) {
    overrides.computeIfAbsent(service, name -> new LinkedHashMap<>()).put(variable, value);
    return this;
  }

  boolean isOverridden(String service, String variable) {
    return overrides.getOrDefault(service, Map.of()).containsKey(variable);
  }

  /**
   * Sets a factory for services of a class whose constructor {@code (ServiceContext)} is not
   * sufficient: for example a board simulated by a program, or a connection that only an Android
   * application can open. Restarts and swaps to that class use it too.
   *
   * @param serviceClass class as in the system file
   */
  public <S extends U2SAService> LaunchOptions making(
      Class<S> serviceClass, Function<ServiceContext, ? extends S> maker) {
    makers.put(serviceClass.getName(), Objects.requireNonNull(maker, "maker"));
    return this;
  }

  /** Sets where services find devices that replace their configured ones; restarts use it too. */
  public LaunchOptions devices(ServiceContext.DeviceSource value) {
    devices = Objects.requireNonNull(value, "devices");
    return this;
  }

  /**
   * Adds a service to those of the system file, such as a recorder: created and started before
   * them, so that it misses nothing, and ended after them.
   *
   * @param configuration its variables
   */
  public LaunchOptions beside(
      XmlConfiguration configuration, Function<ServiceContext, ? extends U2SAService> maker) {
    companions.add(new Companion(configuration, maker));
    return this;
  }

  /** A service in addition to those of the system file. */
  record Companion(
      XmlConfiguration configuration, Function<ServiceContext, ? extends U2SAService> maker) {}

  /**
   * Rejects a class that cannot be instantiated as a service, such as one for a later swap.
   *
   * @throws org.u2sa.interfaces.BadInputException naming the class
   */
  public void requireServiceClass(String className) {
    if (makerOf(className).isEmpty()) {
      ServiceFactory.constructor(className);
    }
  }

  Optional<Function<ServiceContext, ? extends U2SAService>> makerOf(String className) {
    return Optional.ofNullable(makers.get(className));
  }

  /** Sets whether the services of this process already ran in another process of this run. */
  public LaunchOptions restart(boolean value) {
    restart = value;
    return this;
  }

  /**
   * Sets whether the process that started this one runs the Communication Manager. If so, this
   * process uses that process's time, and its services get their names without checking for
   * duplicates.
   */
  public LaunchOptions besideManager(boolean value) {
    besideManager = value;
    return this;
  }

  /**
   * Lets the embedded broker use any free port if the configured one is unavailable.
   *
   * @param told called with the port once the broker is listening
   */
  public LaunchOptions anyPortIfTaken(IntConsumer told) {
    otherPort = Optional.of(told);
    return this;
  }

  /**
   * Makes the services of this process communicate through its broker, regardless of the system
   * file.
   */
  public LaunchOptions throughBroker() {
    throughBroker = true;
    return this;
  }

  /** The configuration of a service of the system, with this run's overrides. */
  public XmlConfiguration configuration(SystemFile.Entry service) {
    return configuration(service.simpleName(), service.configuration());
  }

  /**
   * Reads a configuration file, or uses the variables' defaults, and applies the run's overrides.
   */
  XmlConfiguration configuration(String service, Optional<Path> path) {
    XmlConfiguration configuration =
        path.map(this::load).orElseGet(() -> XmlConfiguration.inMemory(service, Map.of()));
    overrides.getOrDefault(service, Map.of()).forEach(configuration::override);
    return configuration;
  }
}
