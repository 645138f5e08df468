package org.u2sa.messages.marine;

import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A target that is warmer than its neighbours (thesis 4.2); x, y, z is its centre. */
public class HotTarget extends ObjectDescription {
  private static final Schema<HotTarget> SCHEMA =
      Schema.of(HotTarget.class, HotTarget::new, ObjectDescription.TYPE);
  private static final NumberField<HotTarget> EXCESS =
      SCHEMA.optionalNumber("excessTemperature", "K");

  public static final MessageType<HotTarget> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends HotTarget> type() {
    return TYPE;
  }

  /** Temperature above that of the surroundings [K]; 0 if unknown. */
  public double excessTemperature() {
    return get(EXCESS).orElse(0.0);
  }

  public HotTarget excessTemperature(double kelvins) {
    return put(EXCESS, kelvins);
  }
}
