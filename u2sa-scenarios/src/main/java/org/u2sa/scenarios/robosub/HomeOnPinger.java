package org.u2sa.scenarios.robosub;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** Moves above the acoustic pinger of the first type, located by hydrophones. */
public final class HomeOnPinger extends SubTask {
  private static final Schema<HomeOnPinger> SCHEMA =
      Schema.of(HomeOnPinger.class, HomeOnPinger::new, SubTask.TYPE);

  public static final MessageType<HomeOnPinger> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends HomeOnPinger> type() {
    return TYPE;
  }
}
