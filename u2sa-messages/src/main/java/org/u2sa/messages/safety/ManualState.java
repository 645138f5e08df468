package org.u2sa.messages.safety;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Whether the vehicle is driven by hand; also the answer to a {@link ManualOrder}. */
public final class ManualState extends U2SAData {
  /**
   * Prefix of the remark by which a pilot's radio confirms in its health reports that the pilot
   * flies; without it, the Safety Manager does not trust a state of the service PILOT SERVICE.
   */
  public static final String REMARK = "BY HAND";

  /** Prefix of the remark by which it reports that it no longer hears the pilot's radio. */
  public static final String LOSS_REMARK = "RADIO LOST";

  private static final Schema<ManualState> SCHEMA =
      Schema.of(ManualState.class, ManualState::new, U2SAData.TYPE).since(3);
  private static final ValueField<ManualState, Boolean> ACTIVE = SCHEMA.flag("active");
  private static final ValueField<ManualState, String> OPERATOR = SCHEMA.name("operator", "");
  private static final ValueField<ManualState, String> REASON = SCHEMA.optionalNote("reason");
  private static final ValueField<ManualState, String> REQUEST_ID = SCHEMA.optionalId("requestId");
  private static final ValueField<ManualState, Long> TAKEOVERS =
      SCHEMA.optionalCount("takeovers", "");

  public static final MessageType<ManualState> TYPE = SCHEMA.build();

  @Override
  public MessageType<ManualState> type() {
    return TYPE;
  }

  /** Whether {@link ManualDrive} is obeyed instead of navigation. */
  public boolean active() {
    return require(ACTIVE);
  }

  public ManualState active(boolean value) {
    return put(ACTIVE, value);
  }

  /** Name of the current or last driver. */
  public String operator() {
    return require(OPERATOR);
  }

  public ManualState operator(String value) {
    return put(OPERATOR, value);
  }

  /** Why driving by hand ended, or an order to begin it was refused; empty otherwise. */
  public Optional<String> reason() {
    return Optional.ofNullable(get(REASON));
  }

  public ManualState reason(String value) {
    return put(REASON, value);
  }

  /** ID of the order answered; empty if the state changed without an order. */
  public Optional<String> requestId() {
    return Optional.ofNullable(get(REQUEST_ID));
  }

  public ManualState requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** How often driving by hand has begun in this run. */
  public long takeovers() {
    return optionalCount(TAKEOVERS).orElse(0);
  }

  public ManualState takeovers(long value) {
    return put(TAKEOVERS, value);
  }
}
