package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.Recorder;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.ServiceSwap;
import org.u2sa.service.U2SAService;

/** Records a service that amplifies what it hears, for a second, and executes it again. */
final class AmplifierRun {
  static final long STEP_MICROS = 10_000;

  private static final int STEPS = 100;
  private static final int CHANGE_AT = 40; // of GAIN, from 1.5 to 2.5
  private static final int SWAP_AT = 60;

  final Map<String, Object> recorderValues = new HashMap<>();
  final Map<String, Object> overrides = new HashMap<>();
  String moreVariables = ""; // in the configuration file
  boolean asked; // for the service's configuration
  List<Path> files; // of the recording

  private final LocalBus bus = new LocalBus("rover");
  private final Path folder;
  private Recorder recorder;
  private Clock clock;
  private U2SAService last; // in the service's place, if it was to be taken

  /** Makes who takes the service's place; null: nobody. */
  Function<ServiceContext, U2SAService> successor;

  /** Makes who is to take the service's place, and refuses; null: nobody. */
  Function<ServiceContext, U2SAService> refusedSuccessor;

  AmplifierRun(Path folder) {
    this.folder = folder;
  }

  /** Receives nothing. */
  private static final class Silent implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("subscribed to nothing");
    }

    @Override
    public void trouble(String what) {
      throw new IllegalStateException(what);
    }
  }

  /** Publishes GAIN times what it heard last, and its time, at each step. */
  static class Amplifier extends PeriodicService {
    private final VariableDeclaration<Double> gain =
        VariableDeclaration.number("GAIN", "").range(Range.of(0.0, 10.0)).ifAbsent(1.5);
    private double heard;

    Amplifier(ServiceContext context) {
      super(context, ServiceRole.STATE_ESTIMATOR, "Amplifier", 50.0);
      getVariable(gain);
      registerPublisher(Channels.STATE);
      subscribe(Channels.SENSED_STATE, state -> heard = state.x().orElseThrow());
    }

    @Override
    protected void step(double nowS) {
      publish(Channels.STATE, new StateInformation().sensorName("amplified").x(value(heard)));
    }

    double value(double of) {
      return getVariable(gain) * of;
    }
  }

  /** Drives a run: what is to happen at a time, and how time passes. */
  interface Drive {
    void to(long micros) throws InterruptedException;
  }

  /** Has the machine's time. */
  Path recordInRealTime(Function<ServiceContext, U2SAService> maker)
      throws InterruptedException, IOException {
    SystemClock real = new SystemClock();
    return record(
        real,
        until -> {
          try (Clock.Waiter waiter = real.newWaiter("test")) {
            waiter.await(until);
          }
        },
        maker);
  }

  Path recordInLockstep(Function<ServiceContext, U2SAService> maker)
      throws InterruptedException, IOException {
    LockstepClock simulated = new LockstepClock();
    return record(simulated, micros -> simulated.advance(micros - simulated.micros()), maker);
  }

  private Path record(Clock time, Drive drive, Function<ServiceContext, U2SAService> maker)
      throws InterruptedException, IOException {
    clock = time;
    recorder =
        new Recorder(
            ServiceContext.of("rover", XmlConfiguration.inMemory("Recorder", recorderValues))
                .clock(clock)
                .transport(bus)
                .logDirectory(folder)
                .build());
    recorder.start();
    Path file = folder.resolve("Amplifier.xml");
    Files.writeString(
        file,
        "<configuration><variable name=\"GAIN\" type=\"double\" value=\"1.5\"/>"
            + moreVariables
            + "</configuration>");
    XmlConfiguration configuration = XmlConfiguration.load(file, folder.resolve("changed.xml"));
    overrides.forEach(configuration::override);
    U2SAService service = make(maker, context(configuration).build());
    last = service;
    service.start();
    Optional<ServiceSwap> swap = Optional.empty();
    try (Connection publisher = bus.connect("Sensor", new Silent())) {
      long began = clock.micros();
      for (int i = 1; i <= STEPS; i++) {
        publish(
            publisher, Channels.SENSED_STATE, new StateInformation().sensorName("s").x(i / 7.0), i);
        if (i == CHANGE_AT && successor() == null) { // which a change under way would refuse
          publish(
              publisher,
              Channels.CONFIGURATION,
              new ConfigurationChange().serviceName("Amplifier").variableName("GAIN").value("2.5"),
              i);
        }
        if (asked && i % 10 == 0) {
          U2SAData request = new ConfigurationRequest().serviceName("Amplifier");
          publish(publisher, Channels.CONFIGURATION, request, i);
          U2SAData refused =
              new ConfigurationChange().serviceName("Amplifier").variableName("GAIN").value("99");
          publish(publisher, Channels.CONFIGURATION, refused, i);
        }
        if (i == SWAP_AT) {
          swap = orderSwap(service, configuration);
        }
        drive.to(began + i * STEP_MICROS);
      }
    }
    if (swap.isPresent()) {
      Optional<String> refusal = swap.get().await(60.0); // in real time, on a busy machine
      assertThat(refusal.isPresent()).isEqualTo(successor == null);
      drive.to(clock.micros() + 10 * STEP_MICROS);
    }
    for (U2SAService each : List.of(service, last)) {
      each.kill();
      each.join(); // a kill does not wait for ever
    }
    recorder.finish();
    files = recorder.files();
    return files.get(0);
  }

  private Function<ServiceContext, U2SAService> successor() {
    return successor == null ? refusedSuccessor : successor;
  }

  private Optional<ServiceSwap> orderSwap(U2SAService service, XmlConfiguration configuration) {
    if (successor() == null) {
      return Optional.empty();
    }
    last = make(successor(), context(configuration.forSuccessor()).inPlaceOf(service).build());
    return Optional.of(new ServiceSwap(service, last, () -> true).order());
  }

  private ServiceContext.Builder context(XmlConfiguration configuration) {
    return ServiceContext.of("rover", configuration)
        .clock(clock)
        .transport(bus)
        .logDirectory(folder);
  }

  private U2SAService make(Function<ServiceContext, U2SAService> maker, ServiceContext context) {
    ServiceContext kept =
        context.with(recorder.keep(Amplifier.class.getName(), context).orElseThrow());
    U2SAService service = maker.apply(kept);
    kept.execution().made(service);
    return service;
  }

  private static void publish(Connection by, Channel<?> channel, U2SAData message, long micros) {
    message.systemId("rover");
    message.timestamp(micros);
    message.freeze();
    assertThat(by.publish(channel, message)).isTrue();
  }

  Rerun.Outcome rerun(Function<ServiceContext, U2SAService> maker)
      throws IOException, InterruptedException {
    return rerun("Amplifier", maker);
  }

  Rerun.Outcome rerun(String execution, Function<ServiceContext, U2SAService> maker)
      throws IOException, InterruptedException {
    return new Rerun(files, execution, ExecutionStart.all(files).get(execution)).run(maker);
  }

  static ChannelComparison state(Rerun.Outcome outcome) {
    return outcome.channels().stream()
        .filter(channel -> channel.name().equals("state"))
        .findFirst()
        .orElseThrow();
  }
}
