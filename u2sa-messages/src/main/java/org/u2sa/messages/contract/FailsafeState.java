package org.u2sa.messages.contract;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** What the vehicle is to do because something is wrong; CONTINUE if nothing is. */
public final class FailsafeState extends U2SAData {
  private static final Schema<FailsafeState> SCHEMA =
      Schema.of(FailsafeState.class, FailsafeState::new, U2SAData.TYPE).since(2);
  private static final ValueField<FailsafeState, FailsafeAction> ACTION =
      SCHEMA.requiredChoice("action", FailsafeAction.class);
  private static final ValueField<FailsafeState, List<String>> CAUSES = SCHEMA.notes("causes");

  /** The schema. */
  public static final MessageType<FailsafeState> TYPE = SCHEMA.build();

  @Override
  public MessageType<FailsafeState> type() {
    return TYPE;
  }

  /** What the most severe of the causes demands. */
  public FailsafeAction action() {
    return require(ACTION);
  }

  /** Sets {@link #action()}. */
  public FailsafeState action(FailsafeAction value) {
    return put(ACTION, value);
  }

  /** What is wrong, a text each; the most severe first. */
  public List<String> causes() {
    return require(CAUSES);
  }

  /** Sets {@link #causes()}. */
  public FailsafeState causes(List<String> value) {
    return put(CAUSES, List.copyOf(value));
  }
}
