package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
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
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.Recorder;
import org.u2sa.recorder.execution.ChannelComparison.Difference;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

class RerunTest {
  private static final long STEP_MICROS = 10_000;

  @TempDir Path folder;

  private final LocalBus bus = new LocalBus("rover");
  private List<Path> files; // of the recording
  private final Map<String, Object> recorderValues = new HashMap<>();

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
  private static class Amplifier extends PeriodicService {
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

  /** Adds in the order in which a map of objects happens to be. */
  private static final class Unordered extends Amplifier {
    private final Map<Object, Double> terms = new HashMap<>();

    Unordered(ServiceContext context) {
      super(context);
      for (int i = 0; i < 64; i++) {
        terms.put(new Object(), Math.pow(10.0, i % 17) / 3.0);
      }
    }

    @Override
    double value(double of) {
      double sum = 0.0;
      double weight = 1.0;
      for (double term : terms.values()) {
        sum += weight * term;
        weight *= 1.1;
      }
      return sum;
    }
  }

  /** Has the machine's time in what it publishes. */
  private static final class ClockReader extends Amplifier {
    private final Clock machine = new SystemClock();

    ClockReader(ServiceContext context) {
      super(context);
    }

    @Override
    double value(double of) {
      return machine.micros() % 1_000_000;
    }
  }

  /** Publishes from a thread of its own. */
  private static final class Threaded extends Amplifier {
    Threaded(ServiceContext context) {
      super(context);
    }

    @Override
    protected void step(double nowS) {
      Thread other = new Thread(() -> super.step(nowS));
      other.start();
      try {
        other.join();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** Drives a run: what is to happen at a time, and how time passes. */
  private interface Drive {
    void to(long micros) throws InterruptedException;
  }

  private Path record(Clock clock, Drive drive, Function<ServiceContext, U2SAService> maker)
      throws InterruptedException, IOException {
    Recorder recorder =
        new Recorder(
            ServiceContext.of("rover", XmlConfiguration.inMemory("Recorder", recorderValues))
                .clock(clock)
                .transport(bus)
                .logDirectory(folder)
                .build());
    recorder.start();
    Path configuration = folder.resolve("Amplifier.xml");
    Files.writeString(
        configuration,
        "<configuration><variable name=\"GAIN\" type=\"double\" value=\"1.5\"/></configuration>");
    ServiceContext context =
        ServiceContext.of("rover", XmlConfiguration.load(configuration))
            .clock(clock)
            .transport(bus)
            .logDirectory(folder)
            .build();
    ServiceContext kept = context.with(recorder.keep(Amplifier.class.getName(), context).get());
    U2SAService service = maker.apply(kept);
    kept.execution().orElseThrow().made(service);
    service.start();
    try (Connection publisher = bus.connect("Sensor", new Silent())) {
      long began = clock.micros();
      for (int i = 1; i <= 100; i++) {
        publish(
            publisher, Channels.SENSED_STATE, new StateInformation().sensorName("s").x(i / 7.0), i);
        if (i == 40) {
          publish(
              publisher,
              Channels.CONFIGURATION,
              new ConfigurationChange().serviceName("Amplifier").variableName("GAIN").value("2.5"),
              i);
        }
        drive.to(began + i * STEP_MICROS);
      }
    }
    service.kill();
    service.join(); // a kill does not wait for ever
    recorder.finish();
    files = recorder.files();
    return files.get(0);
  }

  private static void publish(Connection by, Channel<?> channel, U2SAData message, long micros) {
    message.systemId("rover");
    message.timestamp(micros);
    message.freeze();
    assertThat(by.publish(channel, message)).isTrue();
  }

  private Path recordInLockstep(Function<ServiceContext, U2SAService> maker)
      throws InterruptedException, IOException {
    LockstepClock clock = new LockstepClock();
    return record(clock, micros -> clock.advance(micros - clock.micros()), maker);
  }

  private static Rerun.Outcome rerun(Path file, Function<ServiceContext, U2SAService> maker)
      throws IOException, InterruptedException {
    return rerun(List.of(file), maker);
  }

  private static Rerun.Outcome rerun(List<Path> files, Function<ServiceContext, U2SAService> maker)
      throws IOException, InterruptedException {
    ExecutionStart start = ExecutionStart.all(files).get("Amplifier");
    return new Rerun(files, "Amplifier", start).run(maker);
  }

  private static ChannelComparison state(Rerun.Outcome outcome) {
    return outcome.channels().stream()
        .filter(channel -> channel.name().equals("state"))
        .findFirst()
        .orElseThrow();
  }

  private static Amplifier withGain(ServiceContext context, double gain) {
    context.configuration().override("GAIN", gain);
    return new Amplifier(context);
  }

  @Test
  void rerun_sameService_isIdentical() throws Exception {
    Path file = recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome = rerun(file, Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isBetween(45L, 55L);
    assertThat(state(outcome).same()).isEqualTo(state(outcome).recorded());
  }

  @Test
  void rerun_severalFiles_isIdenticalOverAll() throws Exception {
    recorderValues.put("SPLIT TIME", 0.3);
    recordInLockstep(Amplifier::new);
    assertThat(files).hasSizeGreaterThan(2);
    Rerun.Outcome outcome = rerun(files, Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isBetween(45L, 55L);
  }

  @Test
  void rerun_secondOfSeveralFilesAlone_saysThatTheFirstIsMissing() throws Exception {
    recorderValues.put("SPLIT TIME", 0.3);
    recordInLockstep(Amplifier::new);
    ExecutionStart start = ExecutionStart.all(files).get("Amplifier");
    Rerun.Outcome outcome = new Rerun(files.subList(1, 2), "Amplifier", start).run(Amplifier::new);
    assertThat(outcome.remarks()).anyMatch(remark -> remark.contains("first file"));
  }

  @Test
  void rerun_recordedInRealTime_isIdentical() throws Exception {
    SystemClock clock = new SystemClock();
    Path file =
        record(
            clock,
            until -> {
              try (Clock.Waiter waiter = clock.newWaiter("test")) {
                waiter.await(until);
              }
            },
            Amplifier::new);
    Rerun.Outcome outcome = rerun(file, Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isPositive();
  }

  @Test
  void rerun_configurationChangedWhileItRan_isChangedAgain() throws Exception {
    Path file = recordInLockstep(Amplifier::new);
    List<Double> seen = new ArrayList<>();
    rerun(
        file,
        context ->
            new Amplifier(context) {
              @Override
              double value(double of) {
                double value = super.value(of);
                if (of > 0.0) {
                  seen.add(value / of);
                }
                return value;
              }
            });
    assertThat(seen.get(0)).isEqualTo(1.5);
    assertThat(seen.get(seen.size() - 1)).isEqualTo(2.5);
    assertThat(folder.resolve("Amplifier.xml")).content().contains("2.5"); // the recorded run's
  }

  @Test
  void rerun_gainChangedInTheSeventhDigit_isFoundAndNamed() throws Exception {
    Path file = recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome = rerun(file, context -> withGain(context, 1.500_000_1));
    assertThat(outcome.isIdentical()).isFalse();
    Difference first = state(outcome).first().orElseThrow();
    assertThat(first.field().field()).isEqualTo("x");
    double recorded = Double.parseDouble(first.field().recorded());
    double now = Double.parseDouble(first.field().now());
    assertThat(now / recorded).isBetween(1.0 + 6e-8, 1.0 + 7e-8);
    assertThat(first.micros()).isBetween(0L, 2 * STEP_MICROS);
    assertThat(state(outcome).deviations()).containsOnlyKeys("x");
    assertThat(state(outcome).deviations().get("x").largest()).isBetween(1e-7, 1e-5);
    assertThat(state(outcome).now()).isEqualTo(state(outcome).recorded());
  }

  @Test
  void rerun_orderOfHashMap_isFoundAndNamed() throws Exception {
    Path file = recordInLockstep(Unordered::new);
    Difference first = state(rerun(file, Unordered::new)).first().orElseThrow();
    assertThat(first.field().field()).isEqualTo("x");
  }

  @Test
  void rerun_clockOfTheMachineIsRead_isFoundAndNamed() throws Exception {
    Path file = recordInLockstep(ClockReader::new);
    Difference first = state(rerun(file, ClockReader::new)).first().orElseThrow();
    assertThat(first.field().field()).isEqualTo("x");
  }

  @Test
  void rerun_publishesFromAnotherThread_isSaid() throws Exception {
    Path file = recordInLockstep(Threaded::new);
    Rerun.Outcome outcome = rerun(file, Threaded::new);
    assertThat(outcome.isIdentical()).isFalse();
    assertThat(outcome.remarks()).anyMatch(remark -> remark.contains("threads of its own"));
  }

  /** Publishes the number of its thread, as some do to tell their orders from those of others. */
  private static final class Numbered extends Amplifier {
    Numbered(ServiceContext context) {
      super(context);
    }

    @Override
    double value(double of) {
      return getThreadID();
    }
  }

  @Test
  void rerun_numberOfThreadIsPublished_isIdentical() throws Exception {
    Path file = recordInLockstep(Numbered::new);
    assertThat(rerun(file, Numbered::new).isIdentical()).isTrue();
  }

  /** Is cut off from all others at its tenth step. */
  private static final class CutOff extends Amplifier {
    private int steps;

    CutOff(ServiceContext context) {
      super(context);
    }

    @Override
    protected void step(double nowS) {
      if (++steps == 10) {
        abandonByOther();
      }
      super.step(nowS);
    }

    private void abandonByOther() {
      Thread other = new Thread(this::abandon);
      other.start();
      boolean interrupted = false;
      while (other.isAlive()) {
        try {
          other.join();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @Test
  void rerun_serviceThatWasCutOff_isIdenticalUpToThere() throws Exception {
    Path file = recordInLockstep(CutOff::new);
    Rerun.Outcome outcome = rerun(file, Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isEqualTo(9);
  }

  @Test
  void rerun_atTwiceTheRate_publishesTwiceAsOften() throws Exception {
    Path file = recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome =
        rerun(
            file,
            context -> {
              context.configuration().override("RATE", 100.0);
              return new Amplifier(context);
            });
    assertThat(state(outcome).now()).isBetween(95L, 105L);
    assertThat(state(outcome).recorded()).isBetween(45L, 55L);
    assertThat(outcome.remarks()).anyMatch(remark -> remark.contains("another order"));
  }

  @Test
  void rerun_atHalfTheRate_publishesHalfAsOften() throws Exception {
    Path file = recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome =
        rerun(
            file,
            context -> {
              context.configuration().override("RATE", 25.0);
              return new Amplifier(context);
            });
    assertThat(state(outcome).now()).isBetween(20L, 30L);
  }

  @Test
  void rerun_lessPublished_isMissing() throws Exception {
    Path file = recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome =
        rerun(
            file,
            context ->
                new Amplifier(context) {
                  private int steps;

                  @Override
                  protected void step(double nowS) {
                    if (++steps != 3) {
                      super.step(nowS);
                    }
                  }
                });
    ChannelComparison state = state(outcome);
    assertThat(state.now()).isEqualTo(state.recorded() - 1);
    assertThat(state.same()).isEqualTo(state.now());
    assertThat(state.first().orElseThrow().field().now()).isEqualTo("no message");
    assertThat(state.first().orElseThrow().micros()).isEqualTo(2 * 20_000L);
  }
}
