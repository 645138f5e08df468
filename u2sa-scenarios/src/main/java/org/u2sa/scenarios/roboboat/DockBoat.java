package org.u2sa.scenarios.roboboat;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A dock to be entered bow first along a straight line, or left in reverse (thesis 4.2). The
 * station is the start of the line, psi its direction.
 */
public final class DockBoat extends BoatTask {
  private static final Schema<DockBoat> SCHEMA =
      Schema.of(DockBoat.class, DockBoat::new, BoatTask.TYPE);
  private static final NumberField<DockBoat> WAY = SCHEMA.requiredNumber("way", "m", 1.0, 100.0);
  private static final ValueField<DockBoat, Boolean> LEAVES = SCHEMA.optionalFlag("leaves");

  public static final MessageType<DockBoat> TYPE = SCHEMA.build();

  @Override
  public MessageType<DockBoat> type() {
    return TYPE;
  }

  /** Length of the straight way from the station to the berth [m]. */
  public double way() {
    return require(WAY);
  }

  /** Whether the boat leaves the dock; otherwise it enters. */
  public boolean leaves() {
    return Boolean.TRUE.equals(get(LEAVES));
  }
}
