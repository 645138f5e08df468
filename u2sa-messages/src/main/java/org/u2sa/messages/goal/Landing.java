package org.u2sa.messages.goal;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Landing of an aircraft at a position whose ground is at altitude {@link #z}; reached when it has
 * stopped. An aeroplane approaches in the direction {@link #psi}, or against the wind; a multirotor
 * descends vertically above the position.
 */
public class Landing extends Waypoint {
  private static final Schema<Landing> SCHEMA =
      Schema.of(Landing.class, Landing::new, Waypoint.TYPE).since(3);
  private static final NumberField<Landing> APPROACH = SCHEMA.optionalNumber("approach", "m", 0.0);
  private static final NumberField<Landing> SLOPE =
      SCHEMA.optionalNumber("slope", "rad", 0.0, Math.PI / 4.0);

  public static final MessageType<Landing> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Landing> type() {
    return TYPE;
  }

  /** Length of an aeroplane's straight descent to the position [m]; empty: the planner's. */
  public OptionalDouble approach() {
    return get(APPROACH);
  }

  public Landing approach(double metres) {
    return put(APPROACH, metres);
  }

  /** Angle of that descent below the horizon [rad, 0…π/4]; empty: the planner's. */
  public OptionalDouble slope() {
    return get(SLOPE);
  }

  public Landing slope(double radians) {
    return put(SLOPE, radians);
  }

  @Override
  public Landing uid(String uid) {
    return (Landing) super.uid(uid);
  }

  @Override
  public Landing next(List<String> uids) {
    return (Landing) super.next(uids);
  }
}
