package org.u2sa.cli.run;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.function.Predicate;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.Setting;
import org.u2sa.cli.record.RunFacts;
import org.u2sa.cli.record.RunRecording;
import org.u2sa.cli.terminal.Console;
import org.u2sa.cli.terminal.PlainLines;
import org.u2sa.core.communication.ManagerVariables;
import org.u2sa.core.communication.discovery.BrokerSearch;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.remote.BrokerAddress;
import org.u2sa.gcs.remote.LocalSystems;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.recorder.Recorder;
import org.u2sa.service.U2SAService;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa run <system.xml>}: runs any system until it ends or is interrupted. */
@Command(
    name = "run",
    description = {
      "Run the system described by a file, in real time.",
      "",
      "The file lists the services of a vehicle, for example config/cessna/system.xml. Each service has its configuration "
          + "file and writes its log file. Ctrl-C or a stop command ends all of them."
    })
public final class RunCommand extends BaseCommand {
  private static final Clock CLOCK = new SystemClock();
  private static final String MANAGER = "CommunicationManager";
  private static final List<String> LOOPBACK = List.of("127.0.0.1", "::1", "localhost");

  @Parameters(paramLabel = "SYSTEM", description = "System file (XML).")
  private Path file;

  @Option(
      names = "--logs",
      paramLabel = "DIR",
      defaultValue = "out/logs",
      description =
          "Folder for log files and saved states, of one running system only. Default: ${DEFAULT-VALUE}.")
  private Path logs;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Random seed. Default: ${DEFAULT-VALUE}.")
  private long seed;

  @Option(
      names = "--set",
      paramLabel = "SERVICE:VARIABLE=VALUE",
      description =
          "Set a configuration variable for this run, for example --set \"PathPlanner:LOOK AHEAD=200.0\". May be given several times.")
  private List<String> settings = List.of();

  @Option(
      names = "--separate",
      description = "Run each service in its own process, connected by MQTT.")
  private boolean separate;

  @Option(
      names = "--only",
      paramLabel = "SERVICE",
      split = ",",
      description =
          "Run only these services, given by simple class name and separated by commas; connect to the Communication Manager at its configured address.")
  private List<String> only = List.of();

  @Option(
      names = "--host",
      paramLabel = "NAME",
      description =
          "Run the services that the file assigns to this host. The host named in "
              + "<communication> runs the Communication Manager; the others connect to its "
              + "configured address.")
  private String host;

  @Option(
      names = "--broker",
      paramLabel = "HOST[:PORT]",
      description =
          "Use this broker instead of starting one, overriding the file; auto: the broker that "
              + "announces this system by mDNS.")
  private String broker;

  @Option(
      names = "--web",
      paramLabel = "PORT",
      description = "Serve the operator's page to browsers on this TCP port.")
  private Integer web; // null if not given

  @Option(
      names = "--rosbridge",
      paramLabel = "PORT",
      description = "Serve the rosbridge protocol to ROS tools on this TCP port (docs/ros.md).")
  private Integer rosbridge; // null if not given

  @Option(
      names = "--through-broker",
      description =
          "Send all messages between the services of this process through the broker; like delivery=\"broker\" in the file.")
  private boolean throughBroker;

  @Mixin private MavlinkLinks mavlink;
  @Mixin private RunRecording recording;

  @Option(
      names = "--supervised",
      hidden = true,
      description = "With --only: the process that started this one restarts it if necessary.")
  private boolean supervised;

  @Option(
      names = "--restart",
      hidden = true,
      description = "With --only: the service ran before and resumes its saved state.")
  private boolean restart;

  @Option(
      names = "--beside-manager",
      hidden = true,
      description = "With --supervised: the supervisor runs the Communication Manager.")
  private boolean besideManager;

  @Override
  @SuppressWarnings("try") // the claim is only closed, never called
  public Integer call() throws InterruptedException {
    SystemFile whole = SystemFile.read(file);
    SystemFile system = whole;
    LaunchOptions options =
        new LaunchOptions().logDirectory(logs).seed(seed).console(out()::println);
    settings = new ArrayList<>(settings);
    serve("--web", ManagerVariables.WEB_PORT, web);
    serve("--rosbridge", ManagerVariables.ROSBRIDGE_PORT, rosbridge);
    if (broker != null) {
      settings.addAll(settingsOfBroker());
    } else if (host == null && only.isEmpty()) {
      refuseSecondRun(system);
      evadeTakenPort(system);
    }
    set(options, system);
    recording.check();
    recording.addTo(options, "", facts(whole));
    options.making(Recorder.class, context -> new Recorder(context, facts(whole).facts()));
    if (throughBroker) {
      options.throughBroker();
    }
    if ((host == null ? 0 : 1) + (only.isEmpty() ? 0 : 1) + (separate ? 1 : 0) > 1) {
      throw wrong("--separate, --only and --host: expected only one of them");
    }
    if (host != null) {
      boolean carriesManager = system.communicationHost().equals(host);
      system = system.onHost(host);
      if (!carriesManager) {
        options.override(MANAGER, "BROKER", "external");
      }
      options.oneOfSeveral(false);
    }
    if (!only.isEmpty()) {
      refuseNamedTwice();
      options.override(MANAGER, "BROKER", "external");
      system = system.only(only);
      options.oneOfSeveral(supervised).restart(restart).besideManager(besideManager);
    }
    try (LogFolderClaim claim = LogFolderClaim.of(logs, system.systemId())) {
      return separate ? runSeparately(system.apart(), options) : run(system, options);
    }
  }

  private void serve(String option, String variable, Integer port) {
    if (port == null) {
      return;
    }
    if (broker != null || !only.isEmpty()) {
      throw wrong(option + ": the port is served by the process that runs the broker");
    }
    settings.add(MANAGER + ":" + variable + "=" + port);
  }

  /**
   * Moves the broker to another port if the configured one is taken, provided that only this
   * machine can reach it: clients on other machines expect the configured port.
   */
  private void evadeTakenPort(SystemFile system) {
    XmlConfiguration configuration =
        system
            .communication()
            .map(XmlConfiguration::load)
            .orElseGet(() -> XmlConfiguration.inMemory(MANAGER, Map.of()));
    List<Setting> ofManager;
    try {
      ofManager = Setting.parseAll(settings).stream().filter(RunCommand::isOfManager).toList();
    } catch (IllegalArgumentException e) {
      return; // rejected later, with all others
    }
    if (ofManager.stream().anyMatch(each -> each.variable().equals(ManagerVariables.PORT))) {
      return;
    }
    ofManager.forEach(each -> configuration.override(each.variable(), each.value()));
    ManagerVariables manager = configuration.settings(ManagerVariables.class).get();
    if (!manager.broker().equals("embedded") || !LOOPBACK.contains(manager.bindAddress())) {
      return;
    }
    int port = manager.communicationManagerPort();
    OptionalInt free = TakenPort.replacement(manager.bindAddress(), port);
    if (free.isPresent()) {
      settings.add(MANAGER + ":" + ManagerVariables.PORT + "=" + free.getAsInt());
      print(
          String.format(
              "Port %s is taken by another program; the broker of this system listens on port %s.",
              port, free.getAsInt()));
    }
  }

  private static boolean isOfManager(Setting setting) {
    return setting.service().equals(MANAGER);
  }

  /** Rejects a second run of the same vehicle, because both would command its devices. */
  private void refuseSecondRun(SystemFile system) {
    LocalSystems.ofAccount().brokers(Optional.of(system.systemId()), this::print).stream()
        .findFirst()
        .ifPresent(
            at -> {
              throw new BadInputException(
                  String.format(
                      "system %s at %s is already running on this machine; end it first",
                      system.systemId(), at));
            });
  }

  private RunFacts facts(SystemFile system) {
    RunFacts facts = new RunFacts().system(system).logs(logs);
    Setting.parseAll(settings)
        .forEach(setting -> facts.setting(setting.service(), setting.variable(), setting.value()));
    return facts;
  }

  private Optional<ParentWatch> parentWatch() {
    if (!supervised) {
      return Optional.empty();
    }
    ParentWatch watch = new ParentWatch(System.in, Runtime.getRuntime()::halt);
    watch.start();
    return Optional.of(watch);
  }

  private void refuseNamedTwice() {
    Set<String> names = new HashSet<>();
    for (String name : only) {
      if (!names.add(name)) {
        throw wrong("--only: \"" + name + "\" is given twice");
      }
    }
  }

  /** Returned as settings, so that child processes use the same broker. */
  private List<String> settingsOfBroker() {
    String manager = MANAGER + ":";
    if (broker.equals(BrokerSearch.AUTO)) {
      return List.of(manager + "BROKER=external", manager + "COMMUNICATION MANAGER IP=" + broker);
    }
    try {
      BrokerAddress address = BrokerAddress.parse(broker);
      return List.of(
          manager + "BROKER=external",
          manager + "COMMUNICATION MANAGER IP=" + address.hostInAddress(),
          manager + "COMMUNICATION MANAGER PORT=" + address.port());
    } catch (IllegalArgumentException e) {
      throw wrong("--broker " + e.getMessage());
    }
  }

  private void set(LaunchOptions options, SystemFile system) {
    try {
      for (Setting setting : Setting.parseAll(settings)) {
        setting.requireServiceOf(system);
        options.override(setting.service(), setting.variable(), setting.value());
      }
    } catch (IllegalArgumentException e) {
      throw wrong("--set: " + e.getMessage());
    }
  }

  @SuppressWarnings("try") // resources that are only closed, never called
  private Integer run(SystemFile file, LaunchOptions options) throws InterruptedException {
    Optional<ParentWatch> parent = parentWatch();
    try (Console.Detached output = PlainLines.detach(out(), CLOCK);
        RunningSystem system = RunningSystem.start(file, options);
        TroubleLines troubles = troublesOf(system, ownServices(system));
        SafetyLines safety = supervised ? null : safetyOf(system);
        LocalSystems.Announcement announced = announced(file, system);
        MavlinkLinks.Bridges bridges = bridges(file, system);
        EndOnInterrupt hook = new EndOnInterrupt(system::close)) {
      parent.ifPresent(watch -> watch.endingBy(system::close));
      print(
          String.format(
              "System %s is running: %s. Ctrl-C ends it.",
              file.systemId(), file.services().isEmpty() ? MANAGER : names(system.services())));
      if (file.services().isEmpty()) {
        new CountDownLatch(1).await(); // the Communication Manager alone, until interrupted
      }
      system.awaitEnd();
      for (U2SAService ended : system.services()) {
        ended
            .endReason()
            .ifPresent(why -> print("Service " + ended.getServiceName() + " ended: " + why));
      }
      for (U2SAService failed : system.failed()) {
        print("Service " + failed.getServiceName() + " failed; see its log file.");
      }
      return system.failed().isEmpty() ? ExitCode.DONE : ExitCode.FAILED;
    }
  }

  @SuppressWarnings("try") // resources that are only closed, never called
  private Integer runSeparately(SystemFile file, LaunchOptions options)
      throws InterruptedException {
    List<String> entries = file.services().stream().map(SystemFile.Entry::simpleName).toList();
    try (Console.Detached output = PlainLines.detach(out(), CLOCK);
        RunningSystem manager = RunningSystem.start(file.withoutServices(), options);
        TroubleLines troubles = troublesOf(manager, any -> true);
        SafetyLines safety = safetyOf(manager);
        LocalSystems.Announcement announced = announced(file, manager);
        MavlinkLinks.Bridges bridges = bridges(file, manager);
        ServiceProcesses processes =
            new ServiceProcesses(startBeside(file, manager), entries, out()::println);
        Supervisor supervisor =
            new Supervisor(file, new KnownNames(options), manager, processes, out()::println);
        EndOnInterrupt hook = new EndOnInterrupt(processes::close)) {
      processes.start();
      print(
          String.format(
              "System %s is running in processes: %s. Ctrl-C ends it.",
              file.systemId(), processes.names()));
      boolean endedWell = processes.awaitEnd().isEmpty();
      if (processes.isRefused()) {
        print("The system is ending: a service rejects its configuration (see above).");
        return ExitCode.BAD_INPUT;
      }
      return endedWell ? ExitCode.DONE : ExitCode.FAILED;
    }
  }

  private ServiceProcesses.ProcessCommand startBeside(SystemFile file, RunningSystem manager) {
    boolean runsManager = manager.communicationManager().address().isPresent();
    return new ServiceProcesses.ProcessCommand(file.file(), logs, seed, settings, runsManager);
  }

  private TroubleLines troublesOf(RunningSystem system, Predicate<String> services) {
    return new TroubleLines(
        system.communicationManager().transport(), services, CLOCK, out()::println);
  }

  private SafetyLines safetyOf(RunningSystem system) {
    return new SafetyLines(
        system.communicationManager().transport(),
        CLOCK,
        Double.POSITIVE_INFINITY, // its operator decides when
        out()::println);
  }

  /**
   * Entries whose faults this process prints; under a supervising process none, because that
   * process prints all.
   */
  private Predicate<String> ownServices(RunningSystem system) {
    Set<String> own = new HashSet<>();
    if (!supervised) {
      system.services().forEach(service -> own.add(service.getServiceName()));
    }
    return own::contains;
  }

  private LocalSystems.Announcement announced(SystemFile file, RunningSystem system) {
    return LocalSystems.ofAccount()
        .announce(file.systemId(), system.communicationManager().address(), out()::println);
  }

  /** A process with only some of the services leaves the links to the process with the broker. */
  private MavlinkLinks.Bridges bridges(SystemFile file, RunningSystem system) {
    return only.isEmpty() ? mavlink.start(file, system, out()::println) : () -> {};
  }

  private static String names(List<U2SAService> services) {
    return String.join(", ", services.stream().map(U2SAService::getServiceName).toList());
  }

  /** Closes a resource in an orderly way when the program is interrupted (Ctrl-C, TERM). */
  private static final class EndOnInterrupt implements AutoCloseable {
    private final Thread hook;

    EndOnInterrupt(Runnable end) {
      hook = new Thread(end, "u2sa-end");
      Runtime.getRuntime().addShutdownHook(hook);
    }

    @Override
    public void close() {
      try {
        Runtime.getRuntime().removeShutdownHook(hook);
      } catch (IllegalStateException e) {
        // Already shutting down: the hook is running.
        return;
      }
    }
  }
}
