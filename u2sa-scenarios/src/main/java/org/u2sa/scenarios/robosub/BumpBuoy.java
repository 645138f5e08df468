package org.u2sa.scenarios.robosub;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** Bumps the buoy of the first type. */
public final class BumpBuoy extends SubTask {
  private static final Schema<BumpBuoy> SCHEMA =
      Schema.of(BumpBuoy.class, BumpBuoy::new, SubTask.TYPE);

  public static final MessageType<BumpBuoy> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends BumpBuoy> type() {
    return TYPE;
  }
}
