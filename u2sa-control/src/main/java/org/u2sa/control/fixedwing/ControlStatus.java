package org.u2sa.control.fixedwing;

import java.util.Collection;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Phase and set points of the aeroplane's control, for displays and logs. */
public final class ControlStatus extends U2SAData {
  private static final Schema<ControlStatus> SCHEMA =
      Schema.of("ControlStatus", ControlStatus.class, ControlStatus::new, U2SAData.TYPE);
  private static final ValueField<ControlStatus, FlightPhase> PHASE =
      SCHEMA.requiredChoice("phase", FlightPhase.class);
  private static final ValueField<ControlStatus, Boolean> NAVIGATING = SCHEMA.flag("navigating");
  private static final NumberField<ControlStatus> BANK = SCHEMA.optionalNumber("bank", "rad");
  private static final NumberField<ControlStatus> PITCH = SCHEMA.optionalNumber("pitch", "rad");
  private static final NumberField<ControlStatus> ALTITUDE = SCHEMA.optionalNumber("altitude", "m");
  private static final NumberField<ControlStatus> AIRSPEED =
      SCHEMA.optionalNumber("airspeed", "m/s", 0.0);

  /** The schema. */
  public static final MessageType<ControlStatus> TYPE = SCHEMA.build();

  /** Channel on which it is published, once a second and on phase changes. */
  public static final Channel<ControlStatus> CHANNEL =
      Channel.latest("control-status", TYPE, U2SAData::systemId);

  @Override
  public MessageType<ControlStatus> type() {
    return TYPE;
  }

  /** Flight phase. */
  public FlightPhase phase() {
    return require(PHASE);
  }

  /** Sets {@link #phase()}. */
  public ControlStatus phase(FlightPhase value) {
    return put(PHASE, value);
  }

  /** Whether navigation is present and fresh; false until set. */
  public boolean navigating() {
    return get(NAVIGATING);
  }

  /** Sets {@link #navigating()}. */
  public ControlStatus navigating(boolean value) {
    return put(NAVIGATING, value);
  }

  /** Bank demanded [rad, right wing down positive]; empty on the ground. */
  public OptionalDouble bank() {
    return get(BANK);
  }

  /** Sets {@link #bank()}. */
  public ControlStatus bank(double rad) {
    return put(BANK, rad);
  }

  /** Pitch demanded [rad, nose up positive]; empty on the ground. */
  public OptionalDouble pitch() {
    return get(PITCH);
  }

  /** Sets {@link #pitch()}. */
  public ControlStatus pitch(double rad) {
    return put(PITCH, rad);
  }

  /** Altitude demanded, above mean sea level [m, up]; empty on the ground. */
  public OptionalDouble altitude() {
    return get(ALTITUDE);
  }

  /** Sets {@link #altitude()}. */
  public ControlStatus altitude(double metres) {
    return put(ALTITUDE, metres);
  }

  /** Calibrated airspeed demanded [m/s]; empty on the ground. */
  public OptionalDouble airspeed() {
    return get(AIRSPEED);
  }

  /** Sets {@link #airspeed()}; not negative. */
  public ControlStatus airspeed(double metresPerSecond) {
    return put(AIRSPEED, metresPerSecond);
  }

  /** Registers the message type. */
  public static final class Provider implements MessageTypeProvider {
    @Override
    public Collection<MessageType<?>> messageTypes() {
      return List.of(TYPE);
    }
  }
}
