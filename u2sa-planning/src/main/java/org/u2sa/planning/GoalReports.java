package org.u2sa.planning;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.service.handover.HandOver;

/** Reports finished goals to the Mission Manager; repeats a report until the manager reacts. */
final class GoalReports {
  private final Consumer<GoalInformation> publish;
  private final LongSupplier intervalMicros;
  private Optional<GoalInformation> last = Optional.empty(); // until the next goal begins
  private long reportedMicros;

  /**
   * @param intervalMicros time after which a report is repeated [µs]
   */
  GoalReports(Consumer<GoalInformation> publish, LongSupplier intervalMicros) {
    this.publish = publish;
    this.intervalMicros = intervalMicros;
  }

  /** The last reported goal, from which the vehicle comes; empty if none. */
  Optional<GoalInformation> last() {
    return last;
  }

  /** Whether the last reported goal has this UID. */
  boolean areOf(String uid) {
    return last.filter(done -> done.uid().equals(uid)).isPresent();
  }

  void forget() {
    last = Optional.empty();
  }

  void report(GoalInformation done, Plan plan, long nowMicros) {
    if (areOf(done.uid())) {
      if (nowMicros - reportedMicros >= intervalMicros.getAsLong()) {
        publish.accept(last.get()); // same timestamp: it counts once
        reportedMicros = nowMicros;
      }
      return;
    }
    GoalInformation report =
        plan.changed().filter(goal -> goal.uid().equals(done.uid())).orElse(done).copy();
    report.timestamp(nowMicros);
    report.completed(plan.progress() == Plan.Progress.COMPLETED);
    report.abandoned(plan.progress() == Plan.Progress.ABANDONED);
    if (report.abandoned() && !plan.remark().isEmpty()) {
      report.reason(plan.remark());
    }
    publish.accept(report);
    last = Optional.of(report);
    reportedMicros = nowMicros;
  }

  void handOver(HandOver state) {
    last.ifPresent(done -> state.message("FINISHED", done));
    state.number("REPORTED AT", Clock.seconds(reportedMicros));
  }

  void takeOver(HandOver state) {
    last = state.message("FINISHED", GoalInformation.class);
    reportedMicros = Clock.micros(state.number("REPORTED AT").orElse(0.0));
  }
}
