package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** State of a battery. */
public final class BatteryState extends U2SAData {
  private static final Schema<BatteryState> SCHEMA =
      Schema.of(BatteryState.class, BatteryState::new, U2SAData.TYPE).since(2);
  private static final ValueField<BatteryState, String> SENSOR_NAME =
      SCHEMA.requiredName("sensorName");
  private static final NumberField<BatteryState> VOLTAGE =
      SCHEMA.optionalNumber("voltage", "V", 0.0);
  private static final NumberField<BatteryState> CURRENT = SCHEMA.optionalNumber("current", "A");
  private static final NumberField<BatteryState> REMAINING =
      SCHEMA.optionalNumber("remaining", "%", 0.0);

  public static final MessageType<BatteryState> TYPE = SCHEMA.build();

  @Override
  public MessageType<BatteryState> type() {
    return TYPE;
  }

  /** Name of the measuring sensor, which distinguishes several batteries. */
  public String sensorName() {
    return require(SENSOR_NAME);
  }

  public BatteryState sensorName(String value) {
    return put(SENSOR_NAME, value);
  }

  /** Terminal voltage [V]. */
  public OptionalDouble voltage() {
    return get(VOLTAGE);
  }

  public BatteryState voltage(double value) {
    return put(VOLTAGE, value);
  }

  /** Discharge current [A]; negative while charging. */
  public OptionalDouble current() {
    return get(CURRENT);
  }

  public BatteryState current(double value) {
    return put(CURRENT, value);
  }

  /** State of charge [%], 0…100. */
  public OptionalDouble remaining() {
    return get(REMAINING);
  }

  public BatteryState remaining(double value) {
    return put(REMAINING, value);
  }
}
