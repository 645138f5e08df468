package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.recorder.execution.AmplifierRun.state;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.recorder.execution.AmplifierRun.Amplifier;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/** A service and the one that took its place while both were recorded. */
class RerunOfSwapTest {
  @TempDir Path folder;

  private AmplifierRun run;

  @BeforeEach
  void begin() {
    run = new AmplifierRun(folder);
  }

  /** Sums what it hears, and goes on from the sum of the one before. */
  private static final class Summing extends Amplifier {
    private double sum;
    private double began;

    Summing(ServiceContext context) {
      super(context);
    }

    @Override
    double value(double of) {
      sum += of;
      return sum + began;
    }

    @Override
    protected void handOver(HandOver state) {
      state.number("sum", sum).number("at", nowS());
      log("hands over");
    }

    @Override
    protected void takeOver(HandOver state) {
      sum = state.number("sum").orElseThrow();
      began = nowS() - state.number("at").orElseThrow() + nowS();
      log("takes over");
    }
  }

  @Test
  void rerun_bothOfASwap_areIdentical() throws Exception {
    run.successor = Summing::new;
    run.recordInLockstep(Summing::new);
    requireIdentical("Amplifier", 25, 35);
    requireIdentical("Amplifier#2", 15, 30);
  }

  @Test
  void rerun_bothOfASwapInRealTime_areIdentical() throws Exception {
    run.successor = Summing::new;
    run.recordInRealTime(Summing::new);
    requireIdentical("Amplifier", 0, 100);
    requireIdentical("Amplifier#2", 0, 100);
  }

  private void requireIdentical(String execution, long atLeast, long atMost) throws Exception {
    Rerun.Outcome outcome = run.rerun(execution, Summing::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    long recorded = outcome.channels().stream().mapToLong(ChannelComparison::recorded).sum();
    assertThat(recorded).isBetween(atLeast, atMost);
  }

  @Test
  void rerun_successorThatForgetsWhatItTookOver_isFound() throws Exception {
    run.successor = Summing::new;
    run.recordInLockstep(Summing::new);
    Rerun.Outcome outcome =
        run.rerun(
            "Amplifier#2",
            context ->
                new Amplifier(context) {
                  private double sum;

                  @Override
                  double value(double of) {
                    sum += of;
                    return sum;
                  }
                });
    assertThat(outcome.isIdentical()).isFalse();
    assertThat(state(outcome).first().orElseThrow().field().field()).isEqualTo("x");
  }

  /** Has a variable that the one after it does not know. */
  private static final class WithLimit extends Amplifier {
    WithLimit(ServiceContext context) {
      super(context);
      getVariable(VariableDeclaration.number("LIMIT", "").range(Range.of(0.0, 10.0)).ifAbsent(1.0));
    }
  }

  @Test
  void rerun_successorWithoutAVariableOfTheFile_isIdentical() throws Exception {
    run.moreVariables = "<variable name=\"LIMIT\" type=\"double\" value=\"3.0\"/>";
    run.successor = Amplifier::new;
    run.recordInLockstep(WithLimit::new);
    Rerun.Outcome outcome = run.rerun("Amplifier#2", Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
  }

  /** Has a length, stated in another unit. */
  private static final class WithLength extends Amplifier {
    private final double lengthM;

    WithLength(ServiceContext context) {
      super(context);
      lengthM =
          getVariable(
              VariableDeclaration.number("LENGTH", "m").range(Range.of(0.0, 99.0)).ifAbsent(1.0));
    }

    @Override
    double value(double of) {
      return of + lengthM;
    }
  }

  @Test
  void rerun_successorOfOneWithAValueInAnotherUnit_isIdentical() throws Exception {
    run.overrides.put("LENGTH", "90 cm");
    run.successor = WithLength::new;
    run.recordInLockstep(WithLength::new);
    Rerun.Outcome outcome = run.rerun("Amplifier#2", WithLength::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
  }

  /** Does not go on where another one was. */
  private static final class Unwilling extends Amplifier {
    Unwilling(ServiceContext context) {
      super(context);
    }

    @Override
    protected void takeOver(HandOver state) {
      throw new IllegalStateException("cannot go on from " + state);
    }
  }

  @Test
  void rerun_swapThatWasRefused_isIdenticalAndTheOtherIsNotKept() throws Exception {
    run.refusedSuccessor = Unwilling::new;
    run.recordInLockstep(Summing::new);
    assertThat(ExecutionStart.all(run.files)).containsOnlyKeys("Amplifier");
    requireIdentical("Amplifier", 45, 65);
  }
}
