package org.u2sa.scenarios.robosub;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** Surfaces inside the floating ring of the first type. */
public final class SurfaceInRing extends SubTask {
  private static final Schema<SurfaceInRing> SCHEMA =
      Schema.of(SurfaceInRing.class, SurfaceInRing::new, SubTask.TYPE);

  public static final MessageType<SurfaceInRing> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends SurfaceInRing> type() {
    return TYPE;
  }
}
