package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Air pressure at a ground station, for pressure altitudes (thesis 4.4.1.2). */
public final class GroundPressure extends U2SAData {
  private static final Schema<GroundPressure> SCHEMA =
      Schema.of(GroundPressure.class, GroundPressure::new, U2SAData.TYPE).since(3);
  private static final ValueField<GroundPressure, String> OPERATOR =
      SCHEMA.requiredName("operator");
  private static final NumberField<GroundPressure> PRESSURE =
      SCHEMA.requiredNumber("pressure", "Pa", 50_000.0, 110_000.0);
  private static final NumberField<GroundPressure> Z = SCHEMA.optionalNumber("z", "m");

  public static final MessageType<GroundPressure> TYPE = SCHEMA.build();

  @Override
  public MessageType<GroundPressure> type() {
    return TYPE;
  }

  /** Author of the measurement. */
  public String operator() {
    return require(OPERATOR);
  }

  public GroundPressure operator(String value) {
    return put(OPERATOR, value);
  }

  /** Static pressure [Pa], 50,000…110,000. */
  public double pressure() {
    return require(PRESSURE);
  }

  public GroundPressure pressure(double pascals) {
    return put(PRESSURE, pascals);
  }

  /** Altitude of the measurement above mean sea level [m]; empty: reduced to sea level (QNH). */
  public OptionalDouble z() {
    return get(Z);
  }

  public GroundPressure z(double metres) {
    return put(Z, metres);
  }
}
