package org.u2sa.messages.mission;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Command to the Mission Manager to switch to a goal now (thesis 3.2.3.2). */
public final class GoalCommand extends U2SAData {
  private static final Schema<GoalCommand> SCHEMA =
      Schema.of(GoalCommand.class, GoalCommand::new, U2SAData.TYPE);
  private static final ValueField<GoalCommand, String> UID = SCHEMA.requiredId("uid");

  public static final MessageType<GoalCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<GoalCommand> type() {
    return TYPE;
  }

  /** UID of the goal to pursue. */
  public String uid() {
    return require(UID);
  }

  public GoalCommand uid(String value) {
    return put(UID, value);
  }
}
