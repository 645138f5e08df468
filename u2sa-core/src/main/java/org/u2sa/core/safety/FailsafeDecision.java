package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.BinaryOperator;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.FailsafeAction;

/**
 * What is to be done because of the hazards at hand: the most severe of what the matrix says of
 * each. A cause counts until it has been gone for CLEAR AFTER. RETURN and what is more severe stays
 * until {@link #acknowledge}, unless RESUME. What is done about the fence stays in any case: the
 * mission that led to it once would do so again.
 */
final class FailsafeDecision {
  /** A hazard that counts. */
  private record Cause(Hazard hazard, FailsafeAction action, String words, long seenMicros) {}

  private static final String OVER = " (over; goes on until armed anew)";

  private final Configurator configuration;
  private final Map<Hazard, Cause> causes = new EnumMap<>(Hazard.class);
  private Cause kept; // the most severe of those that stay though they are gone; null if none does

  FailsafeDecision(Configurator configuration) {
    this.configuration = configuration;
    configuration.getVariable(SafetyVariables.CLEAR_AFTER);
    configuration.getVariable(SafetyVariables.RESUME);
    for (Hazard hazard : Hazard.values()) {
      configuration.getVariable(hazard.action());
    }
  }

  /** What the matrix says of a hazard. */
  FailsafeAction matrix(Hazard hazard) {
    return FailsafeAction.valueOf(configuration.getVariable(hazard.action()));
  }

  /** Takes note of a hazard that is there now. */
  void present(Hazard hazard, String words, long nowMicros) {
    Cause cause = new Cause(hazard, matrix(hazard), words, nowMicros);
    causes.put(hazard, cause);
    if (stays(cause) && (kept == null || cause.action().compareTo(kept.action()) > 0)) {
      kept = cause;
    }
  }

  private boolean stays(Cause cause) {
    if (cause.hazard() == Hazard.FENCE) {
      return cause.action() != FailsafeAction.CONTINUE;
    }
    return cause.action().compareTo(FailsafeAction.RETURN) >= 0
        && !configuration.getVariable(SafetyVariables.RESUME);
  }

  /** Forgets causes that have been gone for long enough. */
  void forgetUntil(long nowMicros) {
    long clearMicros = Clock.micros(configuration.getVariable(SafetyVariables.CLEAR_AFTER));
    causes
        .values()
        .removeIf(
            cause ->
                cause.seenMicros() < nowMicros && nowMicros - cause.seenMicros() >= clearMicros);
  }

  /** Goes on with what a Safety Manager before this one demanded, if that is to stay. */
  void adopt(FailsafeAction action, List<String> words) {
    for (Hazard hazard : Hazard.values()) {
      String prefix = hazard.words() + ": ";
      if (!words.isEmpty() && words.get(0).startsWith(prefix)) {
        String cause = words.get(0).substring(prefix.length()).replace(OVER, "");
        Cause adopted = new Cause(hazard, action, cause, 0);
        kept = stays(adopted) ? adopted : kept;
      }
    }
  }

  /** Begins anew: nothing counts but what is present from now on. */
  void acknowledge() {
    causes.clear();
    kept = null;
  }

  /** What the most severe cause demands. */
  FailsafeAction action() {
    FailsafeAction least = kept == null ? FailsafeAction.CONTINUE : kept.action();
    return causes.values().stream()
        .map(Cause::action)
        .reduce(least, BinaryOperator.maxBy(Comparator.naturalOrder()));
  }

  /** The causes in words, the most severe first. */
  List<String> causes() {
    List<Cause> all = new ArrayList<>(causes.values());
    all.sort((one, other) -> other.action().compareTo(one.action()));
    List<String> words = new ArrayList<>();
    if (kept != null && !causes.containsKey(kept.hazard())) {
      words.add(words(kept) + OVER);
    }
    all.forEach(cause -> words.add(words(cause)));
    return words;
  }

  /** The hazards that count, for noticing a change whatever their words. */
  List<Hazard> hazards() {
    return new ArrayList<>(causes.keySet());
  }

  private static String words(Cause cause) {
    return cause.hazard().words() + ": " + cause.words();
  }
}
