package org.u2sa.messages.marine;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.shape.Box;

/** A target warmer than its surroundings, seen by thermal cameras (thesis 4.2); faces psi. */
public class HotTarget extends Box {
  private static final Schema<HotTarget> SCHEMA =
      Schema.of(HotTarget.class, HotTarget::new, Box.TYPE).since(3);
  private static final NumberField<HotTarget> EXCESS_TEMPERATURE =
      SCHEMA.optionalNumber("excessTemperature", "K");

  public static final MessageType<HotTarget> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends HotTarget> type() {
    return TYPE;
  }

  /** Temperature above the surroundings' [K]; negative if colder, empty if unknown. */
  public OptionalDouble excessTemperature() {
    return get(EXCESS_TEMPERATURE);
  }

  public HotTarget excessTemperature(double kelvin) {
    return put(EXCESS_TEMPERATURE, kelvin);
  }

  @Override
  public HotTarget length(double value) {
    return (HotTarget) super.length(value);
  }

  @Override
  public HotTarget width(double value) {
    return (HotTarget) super.width(value);
  }

  @Override
  public HotTarget height(double value) {
    return (HotTarget) super.height(value);
  }

  @Override
  public HotTarget psi(double value) {
    return (HotTarget) super.psi(value);
  }
}
