package org.u2sa.scenarios.robosub;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** Drops two markers into the bin of the first type. */
public final class DropMarkers extends SubTask {
  private static final Schema<DropMarkers> SCHEMA =
      Schema.of(DropMarkers.class, DropMarkers::new, SubTask.TYPE);

  public static final MessageType<DropMarkers> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends DropMarkers> type() {
    return TYPE;
  }
}
