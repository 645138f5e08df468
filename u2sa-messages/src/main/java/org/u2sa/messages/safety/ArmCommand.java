package org.u2sa.messages.safety;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Request to arm or disarm the vehicle. */
public final class ArmCommand extends U2SAData {
  private static final Schema<ArmCommand> SCHEMA =
      Schema.of(ArmCommand.class, ArmCommand::new, U2SAData.TYPE).since(2);
  private static final ValueField<ArmCommand, String> REQUEST_ID = SCHEMA.requiredId("requestId");
  private static final ValueField<ArmCommand, Boolean> ARM = SCHEMA.flag("arm");
  private static final ValueField<ArmCommand, String> OPERATOR = SCHEMA.name("operator", "");

  public static final MessageType<ArmCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<ArmCommand> type() {
    return TYPE;
  }

  /** Unique ID, chosen by the sender, that the answer repeats. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public ArmCommand requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** True: arm if all checks pass. False: disarm. */
  public boolean arm() {
    return require(ARM);
  }

  public ArmCommand arm(boolean value) {
    return put(ARM, value);
  }

  /** Name of the requester. */
  public String operator() {
    return require(OPERATOR);
  }

  public ArmCommand operator(String value) {
    return put(OPERATOR, value);
  }
}
