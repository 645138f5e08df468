package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.recorder.execution.AmplifierRun.state;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.recorder.execution.AmplifierRun.Amplifier;
import org.u2sa.recorder.execution.ChannelComparison.Difference;
import org.u2sa.service.ServiceContext;

/** What was changed, or cannot be repeated, is found and named. */
class RerunDifferenceTest {
  @TempDir Path folder;

  private AmplifierRun run;

  @BeforeEach
  void begin() {
    run = new AmplifierRun(folder);
  }

  /** Adds in the order in which a map of objects happens to be. */
  private static final class Unordered extends Amplifier {
    private final Map<Object, Double> terms = new HashMap<>();

    Unordered(ServiceContext context) {
      super(context);
      for (int i = 0; i < 64; i++) {
        terms.put(new Object(), Math.pow(10.0, i % 17 - 13) / 3.0);
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

  private static Amplifier withGain(ServiceContext context, double gain) {
    context.configuration().override("GAIN", gain);
    return new Amplifier(context);
  }

  private static NumberComparison onlyNumber(Rerun.Outcome outcome) {
    assertThat(state(outcome).numbers()).hasSize(1);
    return state(outcome).numbers().get(0);
  }

  @Test
  void rerun_gainChangedInTheSeventhDigit_isFoundAndNamed() throws Exception {
    run.recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome = run.rerun(context -> withGain(context, 1.500_000_1));
    assertThat(outcome.isIdentical()).isFalse();
    Difference first = state(outcome).first().orElseThrow();
    assertThat(first.field().field()).isEqualTo("x");
    double recorded = Double.parseDouble(first.field().recorded());
    double now = Double.parseDouble(first.field().now());
    assertThat(now / recorded).isBetween(1.0 + 6e-8, 1.0 + 7e-8);
    assertThat(first.micros()).isBetween(0L, 2 * AmplifierRun.STEP_MICROS);
    NumberComparison x = onlyNumber(outcome);
    assertThat(x.name()).isEqualTo("x (amplified)");
    assertThat(x.unit()).isEqualTo("deg");
    assertThat(x.largest()).isBetween(1e-7, 1e-5);
    assertThat(x.rms()).isBetween(1e-8, x.largest());
    assertThat(state(outcome).now()).isEqualTo(state(outcome).recorded());
  }

  @Test
  void rerun_orderOfHashMap_isFoundAndNamed() throws Exception {
    run.recordInLockstep(Unordered::new);
    Difference first = state(run.rerun(Unordered::new)).first().orElseThrow();
    assertThat(first.field().field()).isEqualTo("x");
  }

  @Test
  void rerun_clockOfTheMachineIsRead_isFoundAndNamed() throws Exception {
    run.recordInLockstep(ClockReader::new);
    Difference first = state(run.rerun(ClockReader::new)).first().orElseThrow();
    assertThat(first.field().field()).isEqualTo("x");
  }

  @Test
  void rerun_publishesFromAnotherThread_isSaid() throws Exception {
    run.recordInLockstep(Threaded::new);
    Rerun.Outcome outcome = run.rerun(Threaded::new);
    assertThat(outcome.isIdentical()).isFalse();
    assertThat(outcome.remarks()).anyMatch(remark -> remark.contains("its own threads"));
  }

  @Test
  void rerun_atTwiceTheRate_publishesTwiceAsOften() throws Exception {
    run.recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome =
        run.rerun(
            context -> {
              context.configuration().override("RATE", 100.0);
              return new Amplifier(context);
            });
    assertThat(state(outcome).now()).isBetween(95L, 105L);
    assertThat(state(outcome).recorded()).isBetween(45L, 55L);
    assertThat(outcome.remarks()).anyMatch(remark -> remark.contains("different order"));
  }

  @Test
  void rerun_atHalfTheRate_publishesHalfAsOften() throws Exception {
    run.recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome =
        run.rerun(
            context -> {
              context.configuration().override("RATE", 25.0);
              return new Amplifier(context);
            });
    assertThat(state(outcome).now()).isBetween(20L, 30L);
    List<Double> times = new ArrayList<>();
    AtomicInteger missing = new AtomicInteger();
    onlyNumber(outcome)
        .forEach(
            (timeS, recorded, now) -> {
              times.add(timeS);
              missing.addAndGet(Double.isNaN(now) ? 1 : 0);
            });
    assertThat(times).isSorted().hasSizeBetween(45, 55);
    assertThat(missing).hasValueBetween(20, 30);
  }

  @Test
  void rerun_lessPublished_isMissing() throws Exception {
    run.recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome =
        run.rerun(
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
