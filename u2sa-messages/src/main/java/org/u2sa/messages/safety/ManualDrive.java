package org.u2sa.messages.safety;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Motion commanded by the person who drives a vehicle by hand, in physical units or as shares of
 * the vehicle's limits. It expires within half a second, so it must be repeated.
 */
public final class ManualDrive extends U2SAData {
  private static final Schema<ManualDrive> SCHEMA =
      Schema.of(ManualDrive.class, ManualDrive::new, U2SAData.TYPE).since(3);
  private static final ValueField<ManualDrive, String> OPERATOR = SCHEMA.name("operator", "");
  private static final NumberField<ManualDrive> SPEED = SCHEMA.optionalNumber("speed", "m/s");
  private static final NumberField<ManualDrive> TURN_RATE =
      SCHEMA.optionalNumber("turnRate", "rad/s");
  private static final NumberField<ManualDrive> SPEED_SHARE =
      SCHEMA.optionalNumber("speedShare", "", -1.0, 1.0);
  private static final NumberField<ManualDrive> TURN_SHARE =
      SCHEMA.optionalNumber("turnShare", "", -1.0, 1.0);

  public static final MessageType<ManualDrive> TYPE = SCHEMA.build();

  @Override
  public MessageType<ManualDrive> type() {
    return TYPE;
  }

  /** Name of the driver; the command counts only if the {@link ManualState} names the same one. */
  public String operator() {
    return require(OPERATOR);
  }

  public ManualDrive operator(String value) {
    return put(OPERATOR, value);
  }

  /** Forward speed [m/s], backward negative; empty: see {@link #speedShare()}. */
  public OptionalDouble speed() {
    return get(SPEED);
  }

  public ManualDrive speed(double value) {
    return put(SPEED, value);
  }

  /** Turn rate [rad/s], left positive; empty: see {@link #turnShare()}. */
  public OptionalDouble turnRate() {
    return get(TURN_RATE);
  }

  public ManualDrive turnRate(double value) {
    return put(TURN_RATE, value);
  }

  /** Share of the maximum speed by hand, −1…1, backward negative; empty: 0. */
  public OptionalDouble speedShare() {
    return get(SPEED_SHARE);
  }

  public ManualDrive speedShare(double value) {
    return put(SPEED_SHARE, value);
  }

  /** Share of the maximum turn rate by hand, −1…1, left positive; empty: 0. */
  public OptionalDouble turnShare() {
    return get(TURN_SHARE);
  }

  public ManualDrive turnShare(double value) {
    return put(TURN_SHARE, value);
  }
}
