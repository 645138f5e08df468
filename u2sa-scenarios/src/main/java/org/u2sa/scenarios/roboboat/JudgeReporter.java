package org.u2sa.scenarios.roboboat;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Reports located targets to the judges (thesis 4.2). In: goal-reports. Out: target-reports, which
 * the judges receive through the boat's broker.
 */
public final class JudgeReporter extends EventDrivenService {
  public JudgeReporter(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "JudgeReporter");
    registerPublisher(TargetReport.CHANNEL);
    subscribe(Channels.GOAL_REPORTS, this::report);
  }

  private void report(GoalInformation goal) {
    if (goal instanceof FindTarget found && found.completed() && found.foundX().isPresent()) {
      String target = String.join(", ", found.objectTypes());
      publish(
          TargetReport.CHANNEL,
          new TargetReport()
              .target(target)
              .place(found.foundX().getAsDouble(), found.foundY().orElseThrow()));
      log(target + " reported to the judges");
    }
  }
}
