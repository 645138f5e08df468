package org.u2sa.scenarios.roboboat;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/**
 * Presses, with the bow, that one of two buttons above the water which is beside a submerged buoy;
 * objectTypes names the buttons, then the buoy (thesis 4.2).
 */
public final class PressButton extends BoatTask {
  private static final Schema<PressButton> SCHEMA =
      Schema.of(PressButton.class, PressButton::new, BoatTask.TYPE);

  public static final MessageType<PressButton> TYPE = SCHEMA.build();

  @Override
  public MessageType<PressButton> type() {
    return TYPE;
  }
}
