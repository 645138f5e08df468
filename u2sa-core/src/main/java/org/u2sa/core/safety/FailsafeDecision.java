package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BinaryOperator;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.service.handover.HandOver;

/**
 * Selects the failsafe action: the most severe one that the matrix gives for the active hazards. A
 * cause stays active until it has been absent for CLEAR AFTER. RETURN and more severe actions latch
 * until {@link #acknowledge}, unless RESUME is set. The fence action always latches, because the
 * mission would breach the fence again.
 */
final class FailsafeDecision {
  /** An active hazard. */
  private record Cause(Hazard hazard, FailsafeAction action, String words, long seenMicros) {}

  private static final String CAUSES = "causes";
  private static final String KEPT = "kept cause";
  private static final String OVER = " (over; stays until armed again)";

  private final Configurator matrix;
  private final Supplier<SafetyVariables> settings;
  private final List<Hazard> hazards;
  private final Map<Hazard, Cause> causes;
  private Cause kept; // most severe latched cause that is gone; null if none

  /**
   * @param hazards all hazards, in the order in which equal causes are reported
   */
  FailsafeDecision(Configurator matrix, Supplier<SafetyVariables> settings, List<Hazard> hazards) {
    this.matrix = matrix;
    this.settings = settings;
    this.hazards = hazards;
    causes = new TreeMap<>(Comparator.comparingInt(hazards::indexOf));
    for (Hazard hazard : hazards) {
      hazard.action(matrix); // declares the variable
    }
  }

  void present(Hazard hazard, String words, long nowMicros) {
    add(new Cause(hazard, hazard.action(matrix), words, nowMicros));
  }

  /** A cause that is only reported for now. */
  void report(Hazard hazard, String words, long nowMicros) {
    add(new Cause(hazard, FailsafeAction.CONTINUE, words, nowMicros));
  }

  private void add(Cause cause) {
    causes.put(cause.hazard(), cause);
    if (stays(cause) && (kept == null || cause.action().compareTo(kept.action()) > 0)) {
      kept = cause;
    }
  }

  private boolean stays(Cause cause) {
    if (cause.hazard() == Hazard.FENCE) {
      return cause.action() != FailsafeAction.CONTINUE;
    }
    return cause.action().compareTo(FailsafeAction.RETURN) >= 0 && !settings.get().resume();
  }

  /** Drops causes that have been absent for long enough. */
  void forgetUntil(long nowMicros) {
    long clearMicros = Clock.micros(settings.get().clearAfter());
    causes
        .values()
        .removeIf(
            cause ->
                cause.seenMicros() < nowMicros && nowMicros - cause.seenMicros() >= clearMicros);
  }

  void handOver(HandOver state) {
    List<String> values = new ArrayList<>();
    causes.values().forEach(cause -> values.addAll(texts(cause)));
    state.texts(CAUSES, values).texts(KEPT, kept == null ? List.of() : texts(kept));
  }

  private static List<String> texts(Cause cause) {
    return List.of(cause.hazard().words(), cause.action().name(), cause.words());
  }

  /** Adopts all causes of the previous Safety Manager, as if they were present now. */
  void takeOver(HandOver state, long nowMicros) {
    for (Cause cause : read(state.texts(CAUSES), nowMicros)) {
      causes.put(cause.hazard(), cause);
    }
    for (Cause cause : read(state.texts(KEPT), nowMicros)) {
      kept = cause;
    }
  }

  /**
   * Adopts an action that stays, as a previous Safety Manager without a saved state published it.
   */
  void resume(FailsafeState before, long nowMicros) {
    for (String words : before.causes()) {
      for (Hazard hazard : hazards) {
        String start = hazard.words() + ": ";
        if (kept == null && words.startsWith(start)) {
          String what = words.substring(start.length()).replace(OVER, "");
          Cause cause = new Cause(hazard, before.action(), what, nowMicros);
          kept = stays(cause) ? cause : null;
        }
      }
    }
  }

  /** The causes written by {@link #texts} whose hazards are known. */
  private List<Cause> read(List<String> values, long nowMicros) {
    List<Cause> read = new ArrayList<>();
    for (int i = 0; i + 2 < values.size(); i += 3) {
      FailsafeAction action = FailsafeAction.valueOf(values.get(i + 1));
      for (Hazard hazard : hazards) {
        if (hazard.words().equals(values.get(i))) {
          read.add(new Cause(hazard, action, values.get(i + 2), nowMicros));
        }
      }
    }
    return read;
  }

  /** State that must be saved whenever it changes. */
  String saved() {
    return causes.keySet() + (kept == null ? "" : " " + kept.hazard() + " " + kept.action());
  }

  /** Clears all causes; only those present from now on count. */
  void acknowledge() {
    causes.clear();
    kept = null;
  }

  /** Action of the most severe cause. */
  FailsafeAction action() {
    FailsafeAction least = kept == null ? FailsafeAction.CONTINUE : kept.action();
    return causes.values().stream()
        .map(Cause::action)
        .reduce(least, BinaryOperator.maxBy(Comparator.naturalOrder()));
  }

  /** The causes in words, most severe first. */
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

  /** The active hazards, for detecting changes regardless of wording. */
  List<Hazard> hazards() {
    return new ArrayList<>(causes.keySet());
  }

  private static String words(Cause cause) {
    return cause.hazard().words() + ": " + cause.words();
  }
}
