package org.u2sa.examples;

import java.util.OptionalDouble;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** The vehicle went below its lowest altitude, or is above it again. */
public final class AltitudeWarning extends U2SAData {
  private static final Schema<AltitudeWarning> SCHEMA =
      Schema.of("AltitudeWarning", AltitudeWarning.class, AltitudeWarning::new, U2SAData.TYPE);
  private static final ValueField<AltitudeWarning, Boolean> LOW = SCHEMA.flag("low");
  private static final NumberField<AltitudeWarning> ALTITUDE =
      SCHEMA.optionalNumber("altitude", "m");

  /** The schema. */
  public static final MessageType<AltitudeWarning> TYPE = SCHEMA.build();

  /** Where it is published. Every warning matters, and who comes late gets the last one. */
  public static final Channel<AltitudeWarning> CHANNEL =
      Channel.every("altitude-warnings", TYPE).retained();

  @Override
  public MessageType<AltitudeWarning> type() {
    return TYPE;
  }

  /** Whether the vehicle is too low; false until set. */
  public boolean low() {
    return get(LOW);
  }

  /** Sets {@link #low()}. */
  public AltitudeWarning low(boolean value) {
    put(LOW, value);
    return this;
  }

  /** Altitude above mean sea level [m, up]; empty until set. */
  public OptionalDouble altitude() {
    return get(ALTITUDE);
  }

  /** Sets {@link #altitude()}. */
  public AltitudeWarning altitude(double metres) {
    put(ALTITUDE, metres);
    return this;
  }
}
