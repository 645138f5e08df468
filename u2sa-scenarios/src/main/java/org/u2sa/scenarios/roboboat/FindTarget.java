package org.u2sa.scenarios.roboboat;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A target on the shore to be located; objectTypes names its type (thesis 4.2). */
public final class FindTarget extends BoatTask {
  private static final Schema<FindTarget> SCHEMA =
      Schema.of(FindTarget.class, FindTarget::new, BoatTask.TYPE);
  private static final NumberField<FindTarget> FOUND_X =
      SCHEMA.optionalNumber("foundX", "deg", -180.0, 180.0);
  private static final NumberField<FindTarget> FOUND_Y =
      SCHEMA.optionalNumber("foundY", "deg", -90.0, 90.0);

  public static final MessageType<FindTarget> TYPE = SCHEMA.build();

  @Override
  public MessageType<FindTarget> type() {
    return TYPE;
  }

  /** Longitude of the target [deg], reported back. */
  public OptionalDouble foundX() {
    return get(FOUND_X);
  }

  /** Latitude of the target [deg], reported back. */
  public OptionalDouble foundY() {
    return get(FOUND_Y);
  }

  FindTarget found(double longitudeDeg, double latitudeDeg) {
    return put(FOUND_X, longitudeDeg).put(FOUND_Y, latitudeDeg);
  }

  @Override
  public FindTarget copy() {
    return (FindTarget) super.copy();
  }
}
