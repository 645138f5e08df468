package org.u2sa.scenarios.robosub;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** Moves in the direction of the path marker of the first type. */
public final class FollowMarker extends SubTask {
  private static final Schema<FollowMarker> SCHEMA =
      Schema.of(FollowMarker.class, FollowMarker::new, SubTask.TYPE);

  public static final MessageType<FollowMarker> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends FollowMarker> type() {
    return TYPE;
  }
}
