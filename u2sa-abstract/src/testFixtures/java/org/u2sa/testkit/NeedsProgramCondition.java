package org.u2sa.testkit;

import java.lang.reflect.AnnotatedElement;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/** Evaluates {@link NeedsProgram} before any of a test's fixtures is created. */
final class NeedsProgramCondition implements ExecutionCondition {
  private final ForeignPrograms programs = ForeignPrograms.ofThisMachine();

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    for (NeedsProgram needed : needed(context.getElement())) {
      Optional<String> missing = programs.missing(needed.value(), needed.modules());
      if (missing.isPresent()) {
        programs.skipped(context.getDisplayName(), missing.get());
        return ConditionEvaluationResult.disabled(missing.get());
      }
    }
    return ConditionEvaluationResult.enabled("every program is here");
  }

  private static List<NeedsProgram> needed(Optional<AnnotatedElement> element) {
    return element
        .map(each -> AnnotationSupport.findRepeatableAnnotations(each, NeedsProgram.class))
        .orElse(List.of());
  }
}
