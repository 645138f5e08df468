package org.u2sa.planning;

import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** A goal that no planner state knows. */
final class Dance extends GoalInformation {
  private static final MessageType<Dance> TYPE =
      Schema.of("Dance", Dance.class, Dance::new, GoalInformation.TYPE).build();

  @Override
  public MessageType<Dance> type() {
    return TYPE;
  }

  @Override
  public Dance uid(String uid) {
    super.uid(uid);
    return this;
  }
}
