package org.u2sa.scenarios.robosub;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** Passes between the first two types of poles; the pole colours determine the side. */
public final class PassGate extends SubTask {
  private static final Schema<PassGate> SCHEMA =
      Schema.of(PassGate.class, PassGate::new, SubTask.TYPE);

  public static final MessageType<PassGate> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends PassGate> type() {
    return TYPE;
  }
}
