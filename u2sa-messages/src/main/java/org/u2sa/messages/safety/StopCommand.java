package org.u2sa.messages.safety;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Command to one service or all services to stop (thesis 3.2.2.1). */
public final class StopCommand extends U2SAData {
  private static final Schema<StopCommand> SCHEMA =
      Schema.of(StopCommand.class, StopCommand::new, U2SAData.TYPE);
  private static final ValueField<StopCommand, Boolean> STOP_ALL = SCHEMA.flag("stopAll");
  private static final ValueField<StopCommand, String> SERVICE_NAME =
      SCHEMA.optionalName("serviceName");

  public static final MessageType<StopCommand> TYPE = SCHEMA.build();

  @Override
  public MessageType<StopCommand> type() {
    return TYPE;
  }

  /** Whether all services of the system are to stop. */
  public boolean stopAll() {
    return require(STOP_ALL);
  }

  public StopCommand stopAll(boolean value) {
    return put(STOP_ALL, value);
  }

  /** Name of the service to stop; empty with {@link #stopAll()}. */
  public Optional<String> serviceName() {
    return Optional.ofNullable(get(SERVICE_NAME));
  }

  public StopCommand serviceName(String value) {
    return put(SERVICE_NAME, value);
  }
}
