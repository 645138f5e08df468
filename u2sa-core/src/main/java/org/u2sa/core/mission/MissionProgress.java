package org.u2sa.core.mission;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.contract.FailsafeAction;
import org.u2sa.service.HandOver;

/**
 * How far the vehicle is: in its mission, or in that of a failsafe, with the mission left where it
 * is to be resumed. Belongs to one thread.
 */
final class MissionProgress {
  private GoalSequence pursued; // the mission, or a failsafe's
  private GoalSequence left; // the mission, for a failsafe; null while it is pursued
  private FailsafeAction pursuedFor = FailsafeAction.CONTINUE;
  private final Set<String> completed = new LinkedHashSet<>();
  private final Set<String> abandoned = new LinkedHashSet<>();

  MissionProgress(GoalSequence mission) {
    pursued = mission;
  }

  /** The goals that are pursued: the mission's, or a failsafe's. */
  GoalSequence pursued() {
    return pursued;
  }

  /** The mission's goals, also while they are left for a failsafe's. */
  private GoalSequence mission() {
    return left == null ? pursued : left;
  }

  /** Begins another mission: at once, or when the failsafe is over. */
  void begin(GoalSequence mission) {
    if (left == null) {
      pursued = mission;
    } else {
      left = mission;
    }
    completed.clear();
    abandoned.clear();
  }

  /** {@link GoalSequence#rules} of the mission. */
  void rules(boolean loop, GoalSequence.Options options) {
    mission().rules(loop, options);
  }

  /** Why the present goals are pursued: CONTINUE for the mission itself. */
  FailsafeAction pursuedFor() {
    return pursuedFor;
  }

  /**
   * Takes note of another failsafe.
   *
   * @param own its own goals; empty if it has none
   * @return whether other goals are pursued now
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
   * Takes note of a goal that was completed or given up.
   *
   * @return false if it is not pursued
   */
  boolean finish(GoalInformation goal) {
    String uid = goal.uid();
    if (!pursued.finish(uid)) {
      return false;
    }
    if (goal.completed()) {
      completed.add(uid);
      abandoned.remove(uid);
    } else {
      abandoned.add(uid);
    }
    return true;
  }

  /** What came of the goals so far, in words. */
  String words() {
    return "completed " + completed + ", given up " + abandoned;
  }

  void handOver(HandOver state) {
    pursued.handOver(state, "PURSUED");
    if (left != null) {
      left.handOver(state, "LEFT");
    }
    state
        .text("PURSUED FOR", pursuedFor.name())
        .texts("COMPLETED", completed)
        .texts("ABANDONED", abandoned);
  }

  /** How far another one was; empty if it did not say so. */
  static Optional<MissionProgress> takenOver(
      HandOver state, boolean loop, GoalSequence.Options options) {
    Optional<GoalSequence> left = GoalSequence.takenOver(state, "LEFT", loop, options);
    return GoalSequence.takenOver(
            state,
            "PURSUED",
            loop && !left.isPresent(), // a failsafe's goals have rules of their own
            left.isPresent() ? GoalSequence.Options.ALL : options)
        .map(
            pursued -> {
              MissionProgress progress = new MissionProgress(pursued);
              progress.left = left.orElse(null);
              progress.pursuedFor =
                  state
                      .text("PURSUED FOR")
                      .map(FailsafeAction::valueOf)
                      .orElse(FailsafeAction.CONTINUE);
              progress.completed.addAll(state.texts("COMPLETED"));
              progress.abandoned.addAll(state.texts("ABANDONED"));
              return progress;
            });
  }
}
