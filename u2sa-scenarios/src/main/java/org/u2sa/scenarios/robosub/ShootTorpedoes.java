package org.u2sa.scenarios.robosub;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/** Shoots two torpedoes through the upright hoop of the first type. */
public final class ShootTorpedoes extends SubTask {
  private static final Schema<ShootTorpedoes> SCHEMA =
      Schema.of(ShootTorpedoes.class, ShootTorpedoes::new, SubTask.TYPE);

  public static final MessageType<ShootTorpedoes> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ShootTorpedoes> type() {
    return TYPE;
  }
}
