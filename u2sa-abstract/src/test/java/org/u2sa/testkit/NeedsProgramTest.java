package org.u2sa.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Proxy;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExtensionContext;

/** A test whose program is missing never begins. */
class NeedsProgramTest {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  private static final class NeedsNothing {}

  @NeedsProgram("sh")
  private static final class NeedsShell {}

  @NeedsProgram("sh")
  @NeedsProgram("no-such-program")
  private static class NeedsTwo {}

  private static final class NeedsWhatItsParentNeeds extends NeedsTwo {}

  private ConditionEvaluationResult judge(Class<?> test, Map<String, String> environment) {
    ExtensionContext context =
        (ExtensionContext)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {ExtensionContext.class},
                (proxy, method, arguments) ->
                    method.getName().equals("getElement")
                        ? Optional.of(test)
                        : test.getSimpleName());
    ForeignPrograms programs = new ForeignPrograms(new PrintStream(out), environment, "/bin");
    return new NeedsProgramCondition(programs).evaluateExecutionCondition(context);
  }

  @Test
  @NeedsProgram("sh")
  void evaluate_needsNothingOrWhatIsHere_runs() {
    assertThat(judge(NeedsNothing.class, Map.of()).isDisabled()).isFalse();
    assertThat(judge(NeedsShell.class, Map.of()).isDisabled()).isFalse();
    assertThat(out).hasToString("");
  }

  @Test
  void evaluate_oneOfTwoIsMissing_isSkippedInOneLine() {
    assertThat(judge(NeedsTwo.class, Map.of()).isDisabled()).isTrue();
    assertThat(out)
        .hasToString(
            "NeedsTwo is skipped: no-such-program is not here (./u2sa test installs it)\n");
  }

  @Test
  void evaluate_parentNeedsWhatIsMissing_isSkipped() {
    assertThat(judge(NeedsWhatItsParentNeeds.class, Map.of()).isDisabled()).isTrue();
  }

  @Test
  void evaluate_missingUnderCi_fails() {
    assertThatThrownBy(() -> judge(NeedsTwo.class, Map.of("CI", "true")))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("no-such-program is not here");
  }
}
