package org.u2sa.mission;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.service.handover.HandOver;

/**
 * Progress of the mission, or of a failsafe's goals while the mission waits to be resumed. Not
 * thread-safe.
 */
final class MissionProgress {
  static final String PAUSED = "PAUSED"; // in the hand-over

  private static final String COMPLETED = "COMPLETED";
  private static final String ABANDONED = "ABANDONED";
  private static final String PURSUED = "PURSUED";
  private static final String LEFT = "LEFT";
  private static final String BEFORE = "BEFORE";

  private GoalSequence pursued; // goals of the mission or of a failsafe
  private GoalSequence left; // the mission's goals while a failsafe is pursued, or null
  private FailsafeAction pursuedFor = FailsafeAction.CONTINUE;
  private Optional<Position> before = Optional.empty(); // position in the mission before a GOTO
  private String commanded = ""; // goal of the latest GOTO
  private final Set<String> completed = new LinkedHashSet<>();
  private final Set<String> abandoned = new LinkedHashSet<>();
  private OptionalLong beganMicros = OptionalLong.empty();
  private OptionalLong beganElsewhere = OptionalLong.empty(); // on another process's clock
  private long elapsedMicros; // of the mission, without failsafes
  private boolean limitPassed;
  private boolean paused;

  MissionProgress(GoalSequence mission) {
    pursued = mission;
  }

  /** The pursued goals: goals of the mission or of a failsafe. */
  GoalSequence pursued() {
    return pursued;
  }

  /** The mission's goals, even while a failsafe's are pursued. */
  GoalSequence mission() {
    return left == null ? pursued : left;
  }

  /**
   * The goal graph that contains a goal: the mission's takes precedence over a failsafe's; the
   * mission's if neither does.
   */
  GoalSequence knowing(String uid) {
    return mission().knows(uid) || !pursued.knows(uid) ? mission() : pursued;
  }

  /** Whether a failsafe's own goals are pursued instead of the mission's. */
  boolean isLeft() {
    return left != null;
  }

  /** Starts another mission: immediately, or after the failsafe. */
  void begin(GoalSequence mission) {
    if (left == null) {
      pursued = mission;
    } else {
      left = mission;
    }
    completed.clear();
    abandoned.clear();
    before = Optional.empty();
    beganMicros = OptionalLong.empty();
    beganElsewhere = OptionalLong.empty();
    elapsedMicros = 0;
    limitPassed = false;
    commanded = "";
  }

  void rules(boolean loop, GoalSequence.Options options) {
    mission().rules(loop, options);
  }

  /** Failsafe action in effect: CONTINUE for the mission itself. */
  FailsafeAction pursuedFor() {
    return pursuedFor;
  }

  /**
   * Handles a change of the failsafe.
   *
   * @param own the failsafe's own goals; empty if none
   * @return whether the pursued goals changed
   */
  boolean turnTo(FailsafeAction action, Optional<GoalSequence> own) {
    pursuedFor = action;
    if (own.isPresent()) {
      left = mission();
      pursued = own.get();
      return true;
    }
    if (left != null && action == FailsafeAction.CONTINUE) {
      pursued = left;
      left = null;
      return true;
    }
    return false;
  }

  /**
   * Handles a goal that was completed or abandoned.
   *
   * @param micros current time [µs of the run's clock]
   * @return false if the goal is not current
   */
  boolean finish(
      String uid, GoalResult result, Optional<GoalInformation> report, String reason, long micros) {
    if (!pursued.finish(uid, result, report, reason, micros)) {
      return false;
    }
    boolean isDone = result == GoalResult.DONE || result == GoalResult.SKIPPED;
    if (left == null && (!uid.equals(commanded) || isDone && isInterrupted(uid))) {
      before = Optional.empty(); // the mission has passed the GOTO goal or the interrupted one
    }
    if (result == GoalResult.DONE) {
      completed.add(uid);
      abandoned.remove(uid);
    } else {
      abandoned.add(uid);
    }
    return true;
  }

  /** Whether a goal alone was current before a GOTO. */
  private boolean isInterrupted(String uid) {
    return before
        .filter(position -> position.current.equals(Collections.singleton(uid)))
        .isPresent();
  }

  /** Pauses the mission, or ends a pause. A failsafe's goals are not affected. */
  void pause(boolean pauses) {
    paused = pauses;
  }

  /** Whether the mission is paused, even while a failsafe's goals are pursued. */
  boolean isPaused() {
    return paused;
  }

  /** Whether the vehicle must hold: the mission is paused and no failsafe's goals are pursued. */
  boolean isHeld() {
    return paused && left == null && !pursued.isOver();
  }

  /** Adds elapsed time up to now [µs]; does not count while paused. */
  void pursuedFor(long micros, long nowMicros) {
    if (beganMicros.isEmpty() && micros > 0) {
      long began = Math.max(0, nowMicros - micros - elapsedMicros);
      beganMicros = OptionalLong.of(began);
      beganElsewhere.ifPresent(then -> mission().book.shiftArrivals(began - then));
      beganElsewhere = OptionalLong.empty();
    }
    if (isHeld()) {
      return;
    }
    pursued.pursuedFor(micros);
    if (left == null && !pursued.isOver()) {
      elapsedMicros += micros;
    }
  }

  /** Whether the mission's time limit has just expired; true only once. */
  boolean passes(OptionalDouble limitS) {
    boolean passes =
        limitS.isPresent()
            && !limitPassed
            && left == null
            && !pursued.isOver()
            && elapsedMicros >= Clock.micros(limitS.getAsDouble());
    limitPassed |= passes;
    return passes;
  }

  /** Start of the mission time [µs of the run's clock]; empty before. */
  OptionalLong beganMicros() {
    return beganMicros;
  }

  double elapsedS() {
    return Clock.seconds(elapsedMicros);
  }

  /**
   * Pursues another goal of the mission or failsafe; one of the mission ends its pause. Remembers
   * the mission's position until the mission passes that goal.
   */
  void changeTo(String uid) {
    paused = paused && left != null;
    if (left == null && !pursued.isOver() && before.isEmpty()) {
      before = Optional.of(pursued.position());
    }
    commanded = left == null ? uid : commanded;
    pursued.changeTo(uid);
  }

  /**
   * Returns to the position before {@link #changeTo}, or before the first of several consecutive
   * calls; false if there is no such position.
   */
  boolean goBack() {
    if (left != null || before.isEmpty()) {
      return false;
    }
    pursued.backTo(before.get());
    before = Optional.empty();
    return true;
  }

  /** Goals to which {@link #goBack} would return. */
  Optional<String> backTo() {
    return left != null
        ? Optional.empty()
        : before.map(position -> position.current.stream().collect(Collectors.joining(", ")));
  }

  /** Whether no goal has been finished yet. */
  boolean isFresh() {
    return completed.isEmpty() && abandoned.isEmpty();
  }

  String words() {
    return "completed " + completed + ", given up " + abandoned;
  }

  void handOver(HandOver state) {
    pursued.handOver(state, PURSUED);
    if (left != null) {
      left.handOver(state, LEFT);
    }
    before.ifPresent(position -> position.handOver(state, BEFORE));
    state
        .text("PURSUED FOR", pursuedFor.name())
        .text("COMMANDED", commanded)
        .texts(COMPLETED, completed)
        .texts(ABANDONED, abandoned)
        .flag("HAS BEFORE", before.isPresent())
        .flag("LIMIT PASSED", limitPassed)
        .flag(PAUSED, paused)
        .number("ELAPSED", Clock.seconds(elapsedMicros));
    beganMicros.ifPresent(micros -> state.number("BEGAN", Clock.seconds(micros)));
  }

  /** Restores the progress of a predecessor; empty if it saved none. */
  static Optional<MissionProgress> takenOver(
      HandOver state, boolean loop, GoalSequence.Options options) {
    Optional<GoalSequence> left = GoalSequence.takenOver(state, LEFT, loop, options);
    return GoalSequence.takenOver(
            state,
            PURSUED,
            loop && !left.isPresent(), // a failsafe's goals have their own rules
            left.isPresent() ? GoalSequence.Options.ALL : options)
        .map(
            pursued -> {
              MissionProgress progress = new MissionProgress(pursued);
              progress.left = left.orElse(null);
              progress.takeOver(state);
              return progress;
            });
  }

  private void takeOver(HandOver state) {
    pursuedFor =
        state.text("PURSUED FOR").map(FailsafeAction::valueOf).orElse(FailsafeAction.CONTINUE);
    commanded = state.text("COMMANDED").orElse("");
    completed.addAll(state.texts(COMPLETED));
    abandoned.addAll(state.texts(ABANDONED));
    if (state.flag("HAS BEFORE")) {
      before = Optional.of(Position.takenOver(state, BEFORE));
    }
    limitPassed = state.flag("LIMIT PASSED");
    paused = state.flag(PAUSED);
    elapsedMicros = Clock.micros(state.number("ELAPSED").orElse(0.0));
    OptionalDouble began = state.number("BEGAN");
    if (began.isPresent()) {
      beganMicros = OptionalLong.of(Clock.micros(began.getAsDouble()));
    }
  }

  /** Leaves a failsafe's goals, because the failsafe of another process is over. */
  void forgetFailsafe() {
    pursued = mission();
    left = null;
    pursuedFor = FailsafeAction.CONTINUE;
    beganElsewhere = beganMicros;
    beganMicros = OptionalLong.empty();
  }
}
