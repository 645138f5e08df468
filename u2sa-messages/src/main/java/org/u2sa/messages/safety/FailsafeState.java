package org.u2sa.messages.safety;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** The active failsafe reaction; CONTINUE if there is no fault. */
public final class FailsafeState extends U2SAData {
  private static final Schema<FailsafeState> SCHEMA =
      Schema.of(FailsafeState.class, FailsafeState::new, U2SAData.TYPE).since(2);
  private static final ValueField<FailsafeState, FailsafeAction> ACTION =
      SCHEMA.requiredChoice("action", FailsafeAction.class);
  private static final ValueField<FailsafeState, List<String>> CAUSES = SCHEMA.notes("causes");

  public static final MessageType<FailsafeState> TYPE = SCHEMA.build();

  @Override
  public MessageType<FailsafeState> type() {
    return TYPE;
  }

  /** Action demanded by the most severe cause. */
  public FailsafeAction action() {
    return require(ACTION);
  }

  public FailsafeState action(FailsafeAction value) {
    return put(ACTION, value);
  }

  /** Faults, one text each, most severe first. */
  public List<String> causes() {
    return require(CAUSES);
  }

  public FailsafeState causes(List<String> value) {
    return put(CAUSES, List.copyOf(value));
  }
}
