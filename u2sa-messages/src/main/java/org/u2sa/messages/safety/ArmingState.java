package org.u2sa.messages.safety;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Whether the vehicle is armed, and if not, why. */
public final class ArmingState extends U2SAData {
  private static final Schema<ArmingState> SCHEMA =
      Schema.of(ArmingState.class, ArmingState::new, U2SAData.TYPE).since(2);
  private static final ValueField<ArmingState, Boolean> ARMED = SCHEMA.flag("armed");
  private static final ValueField<ArmingState, List<String>> REASONS = SCHEMA.notes("reasons");
  private static final ValueField<ArmingState, String> REQUEST_ID = SCHEMA.optionalId("requestId");

  public static final MessageType<ArmingState> TYPE = SCHEMA.build();

  @Override
  public MessageType<ArmingState> type() {
    return TYPE;
  }

  /** Whether the vehicle may move. */
  public boolean armed() {
    return require(ARMED);
  }

  public ArmingState armed(boolean value) {
    return put(ARMED, value);
  }

  /**
   * Reasons against arming, one text per failed check, or why an order to arm was refused, even if
   * the vehicle was armed before; empty if none.
   */
  public List<String> reasons() {
    return require(REASONS);
  }

  public ArmingState reasons(List<String> value) {
    return put(REASONS, List.copyOf(value));
  }

  /** ID of the {@link ArmCommand} answered; empty if the state changed without a command. */
  public Optional<String> requestId() {
    return Optional.ofNullable(get(REQUEST_ID));
  }

  public ArmingState requestId(String value) {
    return put(REQUEST_ID, value);
  }
}
